package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param triangles numbers.
 * @param barycentric rows of 3 values.
 */
public record RegistrationCorrespondence(int[] triangles, double[] barycentric) {}
