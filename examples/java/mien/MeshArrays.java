package mien;

// Written by abi/generate_bindings.py.
/** What a mesh is made of. */
public final class MeshArrays implements Record_ {
    private Values positions;
    private int[] triangles;
    private byte[] colors;
    private float[] texture;
    private int[] textureTriangles;
    private java.util.List<Material> materials;
    private int[] triangleMaterials;
    private java.util.List<Image> images;

    /** With the library's defaults. */
    public MeshArrays() {
    }

    /** #V x 3, F32 or F64, mm */
    public MeshArrays positions(Values value) {
        positions = value;
        return this;
    }
    public Values positions() { return positions; }

    /** #F x 3 tightly packed, counter-clockwise seen from outside; may be left out */
    public MeshArrays triangles(int[] value) {
        triangles = value;
        return this;
    }
    public int[] triangles() { return triangles; }

    /** #V x 3 red green blue, tightly packed; may be left out */
    public MeshArrays colors(byte[] value) {
        colors = value;
        return this;
    }
    public byte[] colors() { return colors; }

    /** #T x 2, (0, 0) at the image's lower left corner; may be left out */
    public MeshArrays texture(float[] value) {
        texture = value;
        return this;
    }
    public float[] texture() { return texture; }

    /** #F x 3 numbers of texture; may be left out: with texture, texture has a row for each vertex */
    public MeshArrays textureTriangles(int[] value) {
        textureTriangles = value;
        return this;
    }
    public int[] textureTriangles() { return textureTriangles; }

    /** may be left out */
    public MeshArrays materials(java.util.List<Material> value) {
        materials = value;
        return this;
    }
    public java.util.List<Material> materials() { return materials; }

    /** #F numbers of materials; null: all are of the first */
    public MeshArrays triangleMaterials(int[] value) {
        triangleMaterials = value;
        return this;
    }
    public int[] triangleMaterials() { return triangleMaterials; }

    /** may be left out */
    public MeshArrays images(java.util.List<Image> value) {
        images = value;
        return this;
    }
    public java.util.List<Image> images() { return images; }

    @Override
    public void fill(Call call, Memory at, int offset) {
        Raw.GET.mien_mesh_arrays_init(at.address + offset, 128);
        call.matrix(at, offset + 8, positions, 3, "positions");
        at.bytes.putLong(offset + 40, Memory.address(call.array(triangles)));
        at.bytes.putLong(offset + 48, call.rows(triangles, 3, "triangles"));
        at.bytes.putLong(offset + 56, Memory.address(call.array(colors)));
        if (colors != null) call.agree("colors", call.rows(colors, 3, "colors"), at.bytes.getLong(offset + 16));
        at.bytes.putLong(offset + 64, Memory.address(call.array(texture)));
        at.bytes.putLong(offset + 72, call.rows(texture, 2, "texture"));
        at.bytes.putLong(offset + 80, Memory.address(call.array(textureTriangles)));
        if (textureTriangles != null) call.agree("texture_triangles", call.rows(textureTriangles, 3, "texture_triangles"), at.bytes.getLong(offset + 48));
        at.bytes.putLong(offset + 88, Memory.address(call.records(materials, 40)));
        at.bytes.putLong(offset + 96, call.rows(materials, 1, "materials"));
        at.bytes.putLong(offset + 104, Memory.address(call.array(triangleMaterials)));
        if (triangleMaterials != null) call.agree("triangle_materials", call.rows(triangleMaterials, 1, "triangle_materials"), at.bytes.getLong(offset + 48));
        at.bytes.putLong(offset + 112, Memory.address(call.records(images, 48)));
        at.bytes.putLong(offset + 120, call.rows(images, 1, "images"));
    }
}
