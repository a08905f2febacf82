package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param triangles triangle (cloud: vertex) numbers of `surface`.
 * @param barycentric rows of 3 values.
 * @param positions rows of 3 values in mm; a lost place keeps where it was.
 */
public record SurfaceTransferPoints(int[] triangles, double[] barycentric, double[] positions) {}
