package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param zoneCount may be left out; the number of zones given.
 * @param zonesDisjoint may be left out; 1 when no vertex lies in two zones: zones and rest then add up.
 */
public record MeasurementZones(int zoneCount, int zonesDisjoint) {}
