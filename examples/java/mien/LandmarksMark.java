package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param where may be left out; MIEN_MARK_*.
 * @param position may be left out; x, y and z in the file's unit, zeros unless it is a place.
 * @param vertex may be left out; 0 unless it is a vertex.
 */
public record LandmarksMark(int where, double position, int vertex) {}
