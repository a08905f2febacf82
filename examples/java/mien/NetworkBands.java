package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param lowCodeCount may be left out; numbers of the low band's code, which come first; all numbers of a
 * network without bands.
 * @param bandLimit may be left out; modes of the low band; -1 for a network without bands.
 */
public record NetworkBands(long lowCodeCount, long bandLimit) {}
