package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param straightMm pair_count values.
 * @param geodesicMm pair_count values; by the heat method, within about one percent; infinite where no
 * surface joins the two.
 */
public record MeasureLengths(double[] straightMm, double[] geodesicMm) {}
