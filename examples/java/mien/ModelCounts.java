package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param vertexCount may be left out; #V.
 * @param scalarModes may be left out; columns of the scalar basis; 3 times as many deformation modes.
 * @param vectorModes may be left out; modes trained on faces.
 */
public record ModelCounts(long vertexCount, long scalarModes, long vectorModes) {}
