package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param count may be left out.
 * @param knownCount may be left out.
 */
public record AnthropometryCounts(long count, long knownCount) {}
