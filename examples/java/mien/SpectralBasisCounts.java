package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param vertexCount may be left out; #V.
 * @param modeCount may be left out; k.
 */
public record SpectralBasisCounts(long vertexCount, long modeCount) {}
