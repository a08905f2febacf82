package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param visitCount may be left out.
 * @param zoneCount may be left out.
 */
public record StudyCounts(int visitCount, int zoneCount) {}
