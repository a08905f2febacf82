package mien;

// Written by abi/generate_bindings.py.
/**
 * A triangle mesh or point cloud, checked: finite coordinates, indices in range. Millimetres. Immutable:
 * share freely between threads.
 */
public final class Mesh extends NativeObject {
    Mesh(long owned) { super(owned, Raw.GET::mien_mesh_release); }

    /** One more object for the same native one: each may be closed by itself. */
    public Mesh share() {
        try (Call call = new Call()) {
            long at = call.use(this);
            Raw.GET.mien_mesh_retain(at);
            return new Mesh(at);
        }
    }

    /**
     * Makes a mesh from the host's arrays, which are copied. C: mien_mesh_create().
     * @param arrays see the fields for shapes and units.
     * @throws MienException MIEN_E_INVALID_ARGUMENT (null, misaligned, stride, dtype), MIEN_E_INVALID_MESH (no
     * vertex, value not finite, index out of range), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public static Mesh create(Session session, MeshArrays arrays) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var arraysAt = call.record(arrays, 128, true, "arrays");
            var outAt = call.room(8);
            call.check(Raw.GET.mien_mesh_create(Memory.address(sessionAt), Memory.address(arraysAt), Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * Reads a mesh file: see mien_mesh_format_extension(). What the file holds tells its format, its name only
     * where that leaves it open. Polygons become triangle fans; colours, texture coordinates, materials and
     * images (of this file and beside it) are kept. Points that are not numbers and part of no triangle are
     * dropped, with a warning in the session's log. The file is treated as hostile. C: mien_mesh_load().
     * @throws MienException MIEN_E_IO, MIEN_E_INVALID_ARGUMENT (unknown extension), MIEN_E_BAD_FORMAT,
     * MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public static Mesh load(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var pathAt = call.text(path);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_mesh_load(Memory.address(sessionAt), Memory.address(pathAt), Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * Writes a mesh file by extension: see mien_mesh_format_writes(). Coordinates are float32 or nine digits
     * where that steps by at most 0.001 mm, else double; STL, which cannot, is refused then. Materials and images
     * are written beside OBJ and PLY files and into GLB files, each image's bytes as they were read. Atomic: a
     * full disk or a crash leaves an old file whole. C: mien_mesh_save().
     * @throws MienException MIEN_E_IO, MIEN_E_INVALID_ARGUMENT (unknown extension, a format that is read only),
     * MIEN_E_INVALID_MESH (STL far from the origin), MIEN_E_UNSUPPORTED_OPTION (pixels, in a build without image
     * coders), MIEN_E_NO_MEMORY
     */
    public void save(Session session, String path) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var meshAt = call.use(this);
            var pathAt = call.text(path);
            call.check(Raw.GET.mien_mesh_save(Memory.address(sessionAt), Memory.address(meshAt), Memory.address(pathAt), call.error()));
        }
    }

    /**
     * Numbers of vertices and triangles. C: mien_mesh_get_counts().
     * @throws MienException MIEN_E_INVALID_HANDLE
     */
    public MeshCounts counts() {
        try (Call call = new Call()) {
            var meshAt = call.use(this);
            var vertexCountAt = call.room(8);
            var triangleCountAt = call.room(8);
            call.check(Raw.GET.mien_mesh_get_counts(Memory.address(meshAt), Memory.address(vertexCountAt), Memory.address(triangleCountAt), call.error()));
            return new MeshCounts(vertexCountAt.bytes.getLong(0), triangleCountAt.bytes.getLong(0));
        }
    }

    /**
     * Copies the positions, #V x 3 tightly packed, mm. With dst null and capacity 0: writes the count only. C:
     * mien_mesh_get_positions().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT
     */
    public double[] positions() {
        try (Call call = new Call()) {
            var meshAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(3 * 8);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 3 * 8);
            } while ((capacity = call.more(Raw.GET.mien_mesh_get_positions(Memory.address(meshAt), 2, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readDoubles(dstAt, rows * 3);
        }
    }

    /**
     * Copies the positions, #V x 3 tightly packed, mm. With dst null and capacity 0: writes the count only. C:
     * mien_mesh_get_positions().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT
     */
    public float[] positionsF32() {
        try (Call call = new Call()) {
            var meshAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(3 * 4);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 3 * 4);
            } while ((capacity = call.more(Raw.GET.mien_mesh_get_positions(Memory.address(meshAt), 1, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readFloats(dstAt, rows * 3);
        }
    }

    /**
     * Copies the triangles, #F x 3 uint32 tightly packed. C: mien_mesh_get_triangles().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT
     */
    public int[] triangles() {
        try (Call call = new Call()) {
            var meshAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(3 * 4);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 3 * 4);
            } while ((capacity = call.more(Raw.GET.mien_mesh_get_triangles(Memory.address(meshAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readInts(dstAt, rows * 3);
        }
    }

    /**
     * Copies the vertex colours, #V x 3 uint8; the count is 0 when the mesh has none. C: mien_mesh_get_colors().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT
     */
    public byte[] colors() {
        try (Call call = new Call()) {
            var meshAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(3);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 3);
            } while ((capacity = call.more(Raw.GET.mien_mesh_get_colors(Memory.address(meshAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readBytes(dstAt, rows * 3);
        }
    }

    /** The number of mesh formats, counted by file extension. C: mien_mesh_format_count(). */
    public static int formatCount() {
        return Raw.GET.mien_mesh_format_count();
    }

    /**
     * The extension of a mesh format: lower case, without its dot, e.g. "ply". C: mien_mesh_format_extension().
     * @param format 0 to mien_mesh_format_count() - 1; null is returned for others.
     */
    public static String formatExtension(int format) {
        return Call.text(Raw.GET.mien_mesh_format_extension(format));
    }

    /**
     * What a mesh format is called, for people, e.g. "Stanford PLY". C: mien_mesh_format_description().
     * @param format 0 to mien_mesh_format_count() - 1; null is returned for others.
     */
    public static String formatDescription(int format) {
        return Call.text(Raw.GET.mien_mesh_format_description(format));
    }

    /**
     * 1 for a format that mien_mesh_save() writes, 0 for one that is only read. C: mien_mesh_format_writes().
     * @param format 0 to mien_mesh_format_count() - 1; 0 is returned for others.
     */
    public static int formatWrites(int format) {
        return Raw.GET.mien_mesh_format_writes(format);
    }

    /**
     * Copies the texture coordinates, #T x 2 float32: (0, 0) is the lower left corner of the image, (1, 1) the
     * upper right. The count is 0 when the mesh has none. C: mien_mesh_get_texture().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT
     */
    public float[] texture() {
        try (Call call = new Call()) {
            var meshAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(2 * 4);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 2 * 4);
            } while ((capacity = call.more(Raw.GET.mien_mesh_get_texture(Memory.address(meshAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readFloats(dstAt, rows * 2);
        }
    }

    /**
     * Copies for each corner of each triangle the number of its texture coordinate, #F x 3 uint32. The count is 0
     * when the mesh has none. C: mien_mesh_get_texture_triangles().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT
     */
    public int[] textureTriangles() {
        try (Call call = new Call()) {
            var meshAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(3 * 4);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 3 * 4);
            } while ((capacity = call.more(Raw.GET.mien_mesh_get_texture_triangles(Memory.address(meshAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readInts(dstAt, rows * 3);
        }
    }

    /**
     * Copies the number of each triangle's material, #F uint32. The count is 0 when the mesh has no material, or
     * a single one that all triangles have. C: mien_mesh_get_triangle_materials().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT
     */
    public int[] triangleMaterials() {
        try (Call call = new Call()) {
            var meshAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(4);
            Memory dstAt;
            do {
                dstAt = call.room(capacity * 4);
            } while ((capacity = call.more(Raw.GET.mien_mesh_get_triangle_materials(Memory.address(meshAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readInts(dstAt, rows);
        }
    }

    /**
     * Numbers of materials and of images. C: mien_mesh_get_material_counts().
     * @throws MienException MIEN_E_INVALID_HANDLE
     */
    public MeshMaterialCounts materialCounts() {
        try (Call call = new Call()) {
            var meshAt = call.use(this);
            var materialCountAt = call.room(8);
            var imageCountAt = call.room(8);
            call.check(Raw.GET.mien_mesh_get_material_counts(Memory.address(meshAt), Memory.address(materialCountAt), Memory.address(imageCountAt), call.error()));
            return new MeshMaterialCounts(materialCountAt.bytes.getLong(0), imageCountAt.bytes.getLong(0));
        }
    }

    /**
     * A material: its base colour and the number of its base colour's image. C: mien_mesh_get_material().
     * @param material 0 to the number of materials - 1.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such material)
     */
    public MeshMaterial material(long material) {
        try (Call call = new Call()) {
            var meshAt = call.use(this);
            var imageAt = call.room(8);
            var redAt = call.room(8);
            var greenAt = call.room(8);
            var blueAt = call.room(8);
            call.check(Raw.GET.mien_mesh_get_material(Memory.address(meshAt), material, Memory.address(imageAt), Memory.address(redAt), Memory.address(greenAt), Memory.address(blueAt), call.error()));
            return new MeshMaterial(imageAt.bytes.getInt(0), redAt.bytes.getDouble(0), greenAt.bytes.getDouble(0), blueAt.bytes.getDouble(0));
        }
    }

    /**
     * Copies a material's name, UTF-8 with its terminating zero. C: mien_mesh_get_material_name().
     * @param material 0 to the number of materials - 1.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such material)
     */
    public String materialName(long material) {
        try (Call call = new Call()) {
            var meshAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_mesh_get_material_name(Memory.address(meshAt), material, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }

    /**
     * Copies an image's file name without a folder, UTF-8 with its terminating zero. C:
     * mien_mesh_get_image_name().
     * @param image 0 to the number of images - 1.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such image)
     */
    public String imageName(long image) {
        try (Call call = new Call()) {
            var meshAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_mesh_get_image_name(Memory.address(meshAt), image, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }

    /**
     * Copies the bytes of an image's file as they were read. The count is 0 for pixels of a host's. C:
     * mien_mesh_get_image_file().
     * @param image 0 to the number of images - 1.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such image)
     */
    public byte[] imageFile(long image) {
        try (Call call = new Call()) {
            var meshAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_mesh_get_image_file(Memory.address(meshAt), image, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readBytes(dstAt, rows);
        }
    }

    /**
     * The width and height of an image in pixels, from its header. C: mien_mesh_get_image_size().
     * @param image 0 to the number of images - 1.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such image), MIEN_E_BAD_FORMAT
     * (damaged), MIEN_E_UNSUPPORTED_OPTION (neither JPEG nor PNG, or above 134 million pixels)
     */
    public MeshImageSize imageSize(long image) {
        try (Call call = new Call()) {
            var meshAt = call.use(this);
            var widthAt = call.room(8);
            var heightAt = call.room(8);
            call.check(Raw.GET.mien_mesh_get_image_size(Memory.address(meshAt), image, Memory.address(widthAt), Memory.address(heightAt), call.error()));
            return new MeshImageSize(widthAt.bytes.getInt(0), heightAt.bytes.getInt(0));
        }
    }

    /**
     * Decodes an image into height rows of width x 3 red green blue bytes, from the top. C:
     * mien_mesh_get_image_pixels().
     * @param image 0 to the number of images - 1.
     * @param rowStrideBytes bytes from row to row of dst, at least 3 * width; 0: tightly packed.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such image, stride below a row),
     * MIEN_E_BAD_FORMAT (damaged), MIEN_E_UNSUPPORTED_OPTION (another kind, or a build without image decoders),
     * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public byte[] imagePixels(Session session, long image, long rowStrideBytes) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var meshAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_mesh_get_image_pixels(Memory.address(sessionAt), Memory.address(meshAt), image, rowStrideBytes, Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            var rows = call.count(countAt);
            return call.readBytes(dstAt, rows);
        }
    }

    /**
     * Writes a GLB file of a mesh and named changes of it (glTF's morph targets): an expression model's
     * blendshapes in one file. Each target is the whole changed mesh, with the vertices of `mesh`. C:
     * mien_mesh_save_targets().
     * @param targets target_count meshes, unless target_count is 0.
     * @param names target_count UTF-8 names, unless target_count is 0.
     * @param path ends with .glb.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (another extension), MIEN_E_MISMATCH
     * (vertex counts), MIEN_E_IO, MIEN_E_NO_MEMORY
     */
    public void saveTargets(Session session, java.util.List<Mesh> targets, java.util.List<String> names, String path) {
        try (Call call = new Call()) {
            call.required(names, "names");
            call.required(targets, "targets");
            call.lock(session);
            var sessionAt = call.use(session);
            var meshAt = call.use(this);
            var targetCount = call.rows(targets, 1, "targets");
            var targetsAt = call.handles(targets);
            call.agree("names", call.rows(names, 1, "names"), targetCount);
            var namesAt = call.texts(names);
            var pathAt = call.text(path);
            call.check(Raw.GET.mien_mesh_save_targets(Memory.address(sessionAt), Memory.address(meshAt), Memory.address(targetsAt), Memory.address(namesAt), targetCount, Memory.address(pathAt), call.error()));
        }
    }

    /**
     * Reads a glTF file with one of its morph targets at full weight. C: mien_mesh_load_target().
     * @param path .glb or .gltf.
     * @param name UTF-8 name of the target
     * @throws MienException MIEN_E_NOT_FOUND (no such target; the message names some), otherwise as
     * mien_mesh_load()
     */
    public static Mesh loadTarget(Session session, String path, String name) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var pathAt = call.text(path);
            var nameAt = call.text(name);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_mesh_load_target(Memory.address(sessionAt), Memory.address(pathAt), Memory.address(nameAt), Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * The positions in place: *data points to #V x 3 float64, tightly packed, mm. C: mien_mesh_positions_view().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT
     */
    public java.nio.DoubleBuffer positionsView() {
        try (Call call = new Call()) {
            var meshAt = call.use(this);
            var dataAt = call.room(8);
            var countAt = call.room(8);
            call.check(Raw.GET.mien_mesh_positions_view(Memory.address(meshAt), Memory.address(dataAt), Memory.address(countAt), call.error()));
            var rows = call.count(countAt);
            return call.lend(dataAt, rows * 3 * 8, this).asDoubleBuffer();
        }
    }

    /**
     * What a mesh is and what is wrong with it, as JSON text: counts, box, extent and the units in which that is
     * a face, a head or a body, pieces, borders, windings, doubled and unused parts, and "faults": a list of
     * sentences that say what is wrong and what to do. C: mien_mesh_inspect().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH,
     * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public String inspect(Session session) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var meshAt = call.use(this);
            var countAt = call.room(8);
            long capacity = call.firstCapacity(1);
            Memory dstAt;
            do {
                dstAt = call.room(capacity);
            } while ((capacity = call.more(Raw.GET.mien_mesh_inspect(Memory.address(sessionAt), Memory.address(meshAt), Memory.address(dstAt), capacity, Memory.address(countAt), call.error()), capacity, countAt)) != 0);
            return call.readText(dstAt, call.count(countAt));
        }
    }

    /**
     * Merges vertices of equal coordinates, drops degenerate, doubled and unused parts and pieces of fewer than
     * min_triangles triangles, and winds all triangles of a piece alike. Order and coordinates of what stays are
     * kept. C: mien_mesh_clean().
     * @param minTriangles 0: all pieces stay.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH,
     * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public Mesh clean(Session session, long minTriangles) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var meshAt = call.use(this);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_mesh_clean(Memory.address(sessionAt), Memory.address(meshAt), minTriangles, Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * Moves every vertex by a row-major 4 x 4 matrix: scales, turns, shifts. When it mirrors (negative
     * determinant), the triangles are wound the other way, so that outside stays outside. C:
     * mien_mesh_transform().
     * @param matrix 16 values, last row 0 0 0 1, invertible.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH,
     * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public Mesh transform(Session session, double[] matrix) {
        try (Call call = new Call()) {
            call.required(matrix, "matrix");
            call.lock(session);
            var sessionAt = call.use(session);
            var meshAt = call.use(this);
            call.agree("matrix", call.rows(matrix, 1, "matrix"), 16);
            var matrixAt = call.array(matrix);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_mesh_transform(Memory.address(sessionAt), Memory.address(meshAt), Memory.address(matrixAt), Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * Winds every triangle the other way: inside becomes outside. C: mien_mesh_turn_over().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH,
     * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public Mesh turnOver(Session session) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var meshAt = call.use(this);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_mesh_turn_over(Memory.address(sessionAt), Memory.address(meshAt), Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * Collapses edges of least quadric error until vertex_count vertices are left or no collapse is legal. Every
     * vertex that stays is one of the input with its place and colour; texture coordinates are dropped. Vertices
     * in which fans of triangles merely touch are split first; triangles that fit into no manifold go. C:
     * mien_mesh_decimate().
     * @param vertexCount at least 4.
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH,
     * MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY
     */
    public Mesh decimate(Session session, long vertexCount) {
        try (Call call = new Call()) {
            call.lock(session);
            var sessionAt = call.use(session);
            var meshAt = call.use(this);
            var outAt = call.room(8);
            call.check(Raw.GET.mien_mesh_decimate(Memory.address(sessionAt), Memory.address(meshAt), vertexCount, Memory.address(outAt), call.error()));
            return call.keep(new Mesh(call.pointer(outAt)));
        }
    }

    /**
     * Fails when one of two meshes of the same face is so many times larger that they cannot be in one unit (7
     * times; mm and cm differ by 10). The message names the unit that would explain it. C:
     * mien_mesh_check_same_unit().
     * @throws MienException MIEN_E_INVALID_HANDLE, MIEN_E_MISMATCH (not in one unit), MIEN_E_NO_MEMORY
     */
    public void checkSameUnit(Mesh second) {
        try (Call call = new Call()) {
            var firstAt = call.use(this);
            var secondAt = call.use(second);
            call.check(Raw.GET.mien_mesh_check_same_unit(Memory.address(firstAt), Memory.address(secondAt), call.error()));
        }
    }
}
