package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param removedMl may be left out; signed, mL.
 * @param sdMl may be left out; posterior deviation, mL.
 */
public record VisitsRemovedVolume(double removedMl, double sdMl) {}
