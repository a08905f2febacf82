package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param vertexCount may be left out; #V.
 * @param codeCount may be left out; numbers of a code.
 */
public record NetworkCounts(long vertexCount, long codeCount) {}
