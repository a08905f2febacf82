// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>A triangle mesh or point cloud, checked: finite coordinates, indices in range. Millimetres. Immutable: share
    /// freely between threads.</summary>
    public sealed unsafe class Mesh : NativeObject
    {
        internal Mesh(IntPtr owned) : base(owned, at => Functions.mien_mesh_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public Mesh Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_mesh_retain(at);
                return new Mesh(at);
            }
        }

        /// <summary>Makes a mesh from the host's arrays, which are copied.</summary>
        /// <param name="arrays">see the fields for shapes and units.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_ARGUMENT (null, misaligned, stride, dtype), MIEN_E_INVALID_MESH (no vertex, value not finite,
        /// index out of range), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_mesh_create()</remarks>
        public static Mesh Create(Session session, MeshArrays arrays)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var arraysAt = call.Record(arrays, sizeof(Native.MeshArrays), false, "arrays");
                var outAt = call.Room(8);
                call.Check(Functions.mien_mesh_create(sessionAt, arraysAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Reads a mesh file: see mien_mesh_format_extension(). What the file holds tells its format, its name only where
        /// that leaves it open. Polygons become triangle fans; colours, texture coordinates, materials and images (of this
        /// file and beside it) are kept. Points that are not numbers and part of no triangle are dropped, with a warning in
        /// the session's log. The file is treated as hostile.</summary>
        /// <exception cref="MienException">MIEN_E_IO, MIEN_E_INVALID_ARGUMENT (unknown extension), MIEN_E_BAD_FORMAT, MIEN_E_INVALID_MESH,
        /// MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_mesh_load()</remarks>
        public static Mesh Load(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_mesh_load(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Writes a mesh file by extension: see mien_mesh_format_writes(). Coordinates are float32 or nine digits where
        /// that steps by at most 0.001 mm, else double; STL, which cannot, is refused then. Materials and images are
        /// written beside OBJ and PLY files and into GLB files, each image's bytes as they were read. Atomic: a full disk
        /// or a crash leaves an old file whole.</summary>
        /// <exception cref="MienException">MIEN_E_IO, MIEN_E_INVALID_ARGUMENT (unknown extension, a format that is read only), MIEN_E_INVALID_MESH (STL far
        /// from the origin), MIEN_E_UNSUPPORTED_OPTION (pixels, in a build without image coders), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_mesh_save()</remarks>
        public void Save(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var meshAt = call.Use(this);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_mesh_save(sessionAt, meshAt, pathAt, call.Error));
            }
        }

        /// <summary>Numbers of vertices and triangles.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_mesh_get_counts()</remarks>
        public MeshCounts GetCounts()
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var vertexCountAt = call.Room(8);
                var triangleCountAt = call.Room(8);
                call.Check(Functions.mien_mesh_get_counts(meshAt, vertexCountAt, triangleCountAt, call.Error));
                return new MeshCounts(*(ulong*)vertexCountAt, *(ulong*)triangleCountAt);
            }
        }

        /// <summary>Copies the positions, #V x 3 tightly packed, mm. With dst null and capacity 0: writes the count only.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_mesh_get_positions()</remarks>
        public double[] GetPositions()
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(3 * 8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 3 * 8);
                } while ((capacity = call.More(Functions.mien_mesh_get_positions(meshAt, 2, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows * 3);
            }
        }

        /// <summary>Copies the positions, #V x 3 tightly packed, mm. With dst null and capacity 0: writes the count only.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_mesh_get_positions()</remarks>
        public float[] GetPositionsF32()
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(3 * 4);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 3 * 4);
                } while ((capacity = call.More(Functions.mien_mesh_get_positions(meshAt, 1, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadFloats(dstAt, rows * 3);
            }
        }

        /// <summary>Copies the triangles, #F x 3 uint32 tightly packed.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_mesh_get_triangles()</remarks>
        public uint[] GetTriangles()
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(3 * 4);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 3 * 4);
                } while ((capacity = call.More(Functions.mien_mesh_get_triangles(meshAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadUints(dstAt, rows * 3);
            }
        }

        /// <summary>Copies the vertex colours, #V x 3 uint8; the count is 0 when the mesh has none.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_mesh_get_colors()</remarks>
        public byte[] GetColors()
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(3);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 3);
                } while ((capacity = call.More(Functions.mien_mesh_get_colors(meshAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadBytes(dstAt, rows * 3);
            }
        }

        /// <summary>The number of mesh formats, counted by file extension.</summary>
        /// <remarks>C: mien_mesh_format_count()</remarks>
        public static uint FormatCount()
        {
            using (var call = new Call())
            {
                return Functions.mien_mesh_format_count();
            }
        }

        /// <summary>The extension of a mesh format: lower case, without its dot, e.g. "ply".</summary>
        /// <param name="format">0 to mien_mesh_format_count() - 1; null is returned for others.</param>
        /// <remarks>C: mien_mesh_format_extension()</remarks>
        public static string FormatExtension(uint format)
        {
            using (var call = new Call())
            {
                return Text.FromNative(Functions.mien_mesh_format_extension(format));
            }
        }

        /// <summary>What a mesh format is called, for people, e.g. "Stanford PLY".</summary>
        /// <param name="format">0 to mien_mesh_format_count() - 1; null is returned for others.</param>
        /// <remarks>C: mien_mesh_format_description()</remarks>
        public static string FormatDescription(uint format)
        {
            using (var call = new Call())
            {
                return Text.FromNative(Functions.mien_mesh_format_description(format));
            }
        }

        /// <summary>1 for a format that mien_mesh_save() writes, 0 for one that is only read.</summary>
        /// <param name="format">0 to mien_mesh_format_count() - 1; 0 is returned for others.</param>
        /// <remarks>C: mien_mesh_format_writes()</remarks>
        public static int FormatWrites(uint format)
        {
            using (var call = new Call())
            {
                return Functions.mien_mesh_format_writes(format);
            }
        }

        /// <summary>Copies the texture coordinates, #T x 2 float32: (0, 0) is the lower left corner of the image, (1, 1) the upper
        /// right. The count is 0 when the mesh has none.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_mesh_get_texture()</remarks>
        public float[] GetTexture()
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(2 * 4);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 2 * 4);
                } while ((capacity = call.More(Functions.mien_mesh_get_texture(meshAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadFloats(dstAt, rows * 2);
            }
        }

        /// <summary>Copies for each corner of each triangle the number of its texture coordinate, #F x 3 uint32. The count is 0 when
        /// the mesh has none.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_mesh_get_texture_triangles()</remarks>
        public uint[] GetTextureTriangles()
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(3 * 4);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 3 * 4);
                } while ((capacity = call.More(Functions.mien_mesh_get_texture_triangles(meshAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadUints(dstAt, rows * 3);
            }
        }

        /// <summary>Copies the number of each triangle's material, #F uint32. The count is 0 when the mesh has no material, or a
        /// single one that all triangles have.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_mesh_get_triangle_materials()</remarks>
        public uint[] GetTriangleMaterials()
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(4);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 4);
                } while ((capacity = call.More(Functions.mien_mesh_get_triangle_materials(meshAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadUints(dstAt, rows);
            }
        }

        /// <summary>Numbers of materials and of images.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_mesh_get_material_counts()</remarks>
        public MeshMaterialCounts GetMaterialCounts()
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var materialCountAt = call.Room(8);
                var imageCountAt = call.Room(8);
                call.Check(Functions.mien_mesh_get_material_counts(meshAt, materialCountAt, imageCountAt, call.Error));
                return new MeshMaterialCounts(*(ulong*)materialCountAt, *(ulong*)imageCountAt);
            }
        }

        /// <summary>A material: its base colour and the number of its base colour's image.</summary>
        /// <param name="material">0 to the number of materials - 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such material)</exception>
        /// <remarks>C: mien_mesh_get_material()</remarks>
        public MeshMaterial GetMaterial(ulong material)
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var imageAt = call.Room(8);
                var redAt = call.Room(8);
                var greenAt = call.Room(8);
                var blueAt = call.Room(8);
                call.Check(Functions.mien_mesh_get_material(meshAt, material, imageAt, redAt, greenAt, blueAt, call.Error));
                return new MeshMaterial(*(int*)imageAt, *(double*)redAt, *(double*)greenAt, *(double*)blueAt);
            }
        }

        /// <summary>Copies a material's name, UTF-8 with its terminating zero.</summary>
        /// <param name="material">0 to the number of materials - 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such material)</exception>
        /// <remarks>C: mien_mesh_get_material_name()</remarks>
        public string GetMaterialName(ulong material)
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_mesh_get_material_name(meshAt, material, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>Copies an image's file name without a folder, UTF-8 with its terminating zero.</summary>
        /// <param name="image">0 to the number of images - 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such image)</exception>
        /// <remarks>C: mien_mesh_get_image_name()</remarks>
        public string GetImageName(ulong image)
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_mesh_get_image_name(meshAt, image, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>Copies the bytes of an image's file as they were read. The count is 0 for pixels of a host's.</summary>
        /// <param name="image">0 to the number of images - 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such image)</exception>
        /// <remarks>C: mien_mesh_get_image_file()</remarks>
        public byte[] GetImageFile(ulong image)
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_mesh_get_image_file(meshAt, image, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadBytes(dstAt, rows);
            }
        }

        /// <summary>The width and height of an image in pixels, from its header.</summary>
        /// <param name="image">0 to the number of images - 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such image), MIEN_E_BAD_FORMAT (damaged),
        /// MIEN_E_UNSUPPORTED_OPTION (neither JPEG nor PNG, or above 134 million pixels)</exception>
        /// <remarks>C: mien_mesh_get_image_size()</remarks>
        public MeshImageSize GetImageSize(ulong image)
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var widthAt = call.Room(8);
                var heightAt = call.Room(8);
                call.Check(Functions.mien_mesh_get_image_size(meshAt, image, widthAt, heightAt, call.Error));
                return new MeshImageSize(*(uint*)widthAt, *(uint*)heightAt);
            }
        }

        /// <summary>Decodes an image into height rows of width x 3 red green blue bytes, from the top.</summary>
        /// <param name="image">0 to the number of images - 1.</param>
        /// <param name="rowStrideBytes">bytes from row to row of dst, at least 3 * width; 0: tightly packed.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such image, stride below a row), MIEN_E_BAD_FORMAT (damaged),
        /// MIEN_E_UNSUPPORTED_OPTION (another kind, or a build without image decoders), MIEN_E_MEMORY_BUDGET,
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_mesh_get_image_pixels()</remarks>
        public byte[] GetImagePixels(Session session, ulong image, ulong rowStrideBytes)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var meshAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_mesh_get_image_pixels(sessionAt, meshAt, image, rowStrideBytes, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadBytes(dstAt, rows);
            }
        }

        /// <summary>Writes a GLB file of a mesh and named changes of it (glTF's morph targets): an expression model's blendshapes in
        /// one file. Each target is the whole changed mesh, with the vertices of `mesh`.</summary>
        /// <param name="targets">target_count meshes, unless target_count is 0.</param>
        /// <param name="names">target_count UTF-8 names, unless target_count is 0.</param>
        /// <param name="path">ends with .glb.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (another extension), MIEN_E_MISMATCH (vertex counts), MIEN_E_IO,
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_mesh_save_targets()</remarks>
        public void SaveTargets(Session session, IReadOnlyList<Mesh> targets, IReadOnlyList<string> names, string path)
        {
            using (var call = new Call())
            {
                call.Required(names, "names");
                call.Required(targets, "targets");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var meshAt = call.Use(this);
                var targetCount = call.Rows(targets, 1, "targets");
                var targetsAt = call.Handles(targets);
                call.Agree("names", call.Rows(names, 1, "names"), targetCount);
                var namesAt = call.Texts(names);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_mesh_save_targets(sessionAt, meshAt, targetsAt, namesAt, (ulong)targetCount, pathAt, call.Error));
            }
        }

        /// <summary>Reads a glTF file with one of its morph targets at full weight.</summary>
        /// <param name="path">.glb or .gltf.</param>
        /// <param name="name">UTF-8 name of the target</param>
        /// <exception cref="MienException">MIEN_E_NOT_FOUND (no such target; the message names some), otherwise as mien_mesh_load()</exception>
        /// <remarks>C: mien_mesh_load_target()</remarks>
        public static Mesh LoadTarget(Session session, string path, string name)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var nameAt = call.Text(name);
                var outAt = call.Room(8);
                call.Check(Functions.mien_mesh_load_target(sessionAt, pathAt, nameAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>The positions in place: *data points to #V x 3 float64, tightly packed, mm.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_mesh_positions_view()</remarks>
        public ReadOnlyMemory<double> GetPositionsView()
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var dataAt = call.Room(8);
                var countAt = call.Room(8);
                call.Check(Functions.mien_mesh_positions_view(meshAt, dataAt, countAt, call.Error));
                var rows = call.Count(countAt);
                return call.Lend<double>(*(IntPtr*)dataAt, rows * 3, this);
            }
        }

        /// <summary>What a mesh is and what is wrong with it, as JSON text: counts, box, extent and the units in which that is a
        /// face, a head or a body, pieces, borders, windings, doubled and unused parts, and "faults": a list of sentences
        /// that say what is wrong and what to do.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_mesh_inspect()</remarks>
        public string Inspect(Session session)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var meshAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_mesh_inspect(sessionAt, meshAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>Merges vertices of equal coordinates, drops degenerate, doubled and unused parts and pieces of fewer than
        /// min_triangles triangles, and winds all triangles of a piece alike. Order and coordinates of what stays are kept.</summary>
        /// <param name="minTriangles">0: all pieces stay.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_mesh_clean()</remarks>
        public Mesh Clean(Session session, ulong minTriangles)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var meshAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_mesh_clean(sessionAt, meshAt, minTriangles, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Moves every vertex by a row-major 4 x 4 matrix: scales, turns, shifts. When it mirrors (negative determinant),
        /// the triangles are wound the other way, so that outside stays outside.</summary>
        /// <param name="matrix">16 values, last row 0 0 0 1, invertible.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_mesh_transform()</remarks>
        public Mesh Transform(Session session, double[] matrix)
        {
            using (var call = new Call())
            {
                call.Required(matrix, "matrix");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var meshAt = call.Use(this);
                call.Agree("matrix", call.Rows(matrix, 1, "matrix"), 16);
                var matrixAt = call.Array(matrix);
                var outAt = call.Room(8);
                call.Check(Functions.mien_mesh_transform(sessionAt, meshAt, matrixAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Winds every triangle the other way: inside becomes outside.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_mesh_turn_over()</remarks>
        public Mesh TurnOver(Session session)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var meshAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_mesh_turn_over(sessionAt, meshAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Collapses edges of least quadric error until vertex_count vertices are left or no collapse is legal. Every
        /// vertex that stays is one of the input with its place and colour; texture coordinates are dropped. Vertices in
        /// which fans of triangles merely touch are split first; triangles that fit into no manifold go.</summary>
        /// <param name="vertexCount">at least 4.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_mesh_decimate()</remarks>
        public Mesh Decimate(Session session, ulong vertexCount)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var meshAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_mesh_decimate(sessionAt, meshAt, vertexCount, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Fails when one of two meshes of the same face is so many times larger that they cannot be in one unit (7 times;
        /// mm and cm differ by 10). The message names the unit that would explain it.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_MISMATCH (not in one unit), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_mesh_check_same_unit()</remarks>
        public void CheckSameUnit(Mesh second)
        {
            using (var call = new Call())
            {
                var firstAt = call.Use(this);
                var secondAt = call.Use(second);
                call.Check(Functions.mien_mesh_check_same_unit(firstAt, secondAt, call.Error));
            }
        }
    }
}
