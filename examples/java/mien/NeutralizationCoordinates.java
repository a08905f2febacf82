package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param identity identity_modes values.
 * @param expression expression_modes values.
 */
public record NeutralizationCoordinates(double[] identity, double[] expression) {}
