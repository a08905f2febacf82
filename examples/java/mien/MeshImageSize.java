package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param width may be left out; pixels.
 * @param height may be left out; pixels.
 */
public record MeshImageSize(int width, int height) {}
