package mien;

// Written by abi/generate_bindings.py.
/**
 * What comes out of one call.
 * @param materialCount may be left out.
 * @param imageCount may be left out.
 */
public record MeshMaterialCounts(long materialCount, long imageCount) {}
