package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param vertexCount may be left out; #V.
 * @param triangleCount may be left out; #F.
 */
public record MeshCounts(long vertexCount, long triangleCount) {}
