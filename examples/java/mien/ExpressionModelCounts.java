package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param vertexCount may be left out; #V.
 * @param identityModes may be left out.
 * @param expressionModes may be left out.
 */
public record ExpressionModelCounts(long vertexCount, int identityModes, int expressionModes) {}
