package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param count may be left out.
 * @param pickedCount may be left out.
 */
public record LandmarksCounts(long count, long pickedCount) {}
