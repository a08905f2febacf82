package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param low may be left out; the low band's mesh.
 * @param high may be left out; the high band's mesh.
 */
public record SpectralSplit(Mesh low, Mesh high) {}
