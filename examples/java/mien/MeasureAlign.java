package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param info may be left out
 * @param out the moved mesh.
 */
public record MeasureAlign(ZoneAlignment info, Mesh out) {}
