package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param image may be left out; -1: none.
 * @param red may be left out; 0 to 1.
 * @param green may be left out; 0 to 1.
 * @param blue may be left out; 0 to 1.
 */
public record MeshMaterial(int image, double red, double green, double blue) {}
