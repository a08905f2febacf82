package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param rows numbers of vertices that the map ends at.
 * @param columns numbers of vertices that it starts from.
 * @param values float64.
 * @param rowCount may be left out; vertices that the map ends at.
 * @param columnCount may be left out; vertices that it starts from.
 */
public record HierarchyMap(int[] rows, int[] columns, double[] values, long rowCount, long columnCount) {}
