package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param scanCount may be left out.
 * @param runCount may be left out.
 */
public record BatchCounts(int scanCount, int runCount) {}
