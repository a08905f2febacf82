package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param motion may be left out; 12 float64: the rigid motion onto the mean, x -&gt; R x + t, as R row by
 * row, then t in mm. mien_network_decode() takes it back.
 * @param dst values.
 */
public record NetworkEncode(double[] motion, double[] dst) {}
