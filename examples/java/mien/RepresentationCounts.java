package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param vertexCount may be left out; #V.
 * @param channelCount may be left out; 3, or 9 for deformations.
 */
public record RepresentationCounts(long vertexCount, long channelCount) {}
