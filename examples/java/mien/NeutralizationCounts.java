package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param vertexCount may be left out; #V.
 * @param identityModes may be left out; those of the model.
 * @param expressionModes may be left out; those of the model.
 */
public record NeutralizationCounts(long vertexCount, int identityModes, int expressionModes) {}
