package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param coverage may be left out; share of before's area that had a partner, 0 to 1.
 * @param out the measurement.
 */
public record MeasureScanVolume(double coverage, Measurement out) {}
