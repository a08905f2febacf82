// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What a mesh is made of.</summary>
    public sealed unsafe class MeshArrays : Record
    {
        /// <summary>#V x 3, F32 or F64, mm</summary>
        public Values Positions { get; set; }
        /// <summary>#F x 3 tightly packed, counter-clockwise seen from outside; may be left out</summary>
        public uint[] Triangles { get; set; }
        /// <summary>#V x 3 red green blue, tightly packed; may be left out</summary>
        public byte[] Colors { get; set; }
        /// <summary>#T x 2, (0, 0) at the image's lower left corner; may be left out</summary>
        public float[] Texture { get; set; }
        /// <summary>#F x 3 numbers of texture; may be left out: with texture, texture has a row for each vertex</summary>
        public uint[] TextureTriangles { get; set; }
        /// <summary>may be left out</summary>
        public IReadOnlyList<Material> Materials { get; set; }
        /// <summary>#F numbers of materials; null: all are of the first</summary>
        public uint[] TriangleMaterials { get; set; }
        /// <summary>may be left out</summary>
        public IReadOnlyList<Image> Images { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.MeshArrays*)at;
            Functions.mien_mesh_arrays_init(at, (UIntPtr)sizeof(Native.MeshArrays));
            raw->positions = call.Matrix(Positions, 3, "positions");
            raw->triangles = call.Array(Triangles);
            raw->triangleCount = (ulong)call.Rows(Triangles, 3, "triangles");
            raw->colors = call.Array(Colors);
            if (Colors != null) call.Agree("colors", call.Rows(Colors, 3, "colors"), (long)raw->positions.count);
            raw->texture = call.Array(Texture);
            raw->textureCount = (ulong)call.Rows(Texture, 2, "texture");
            raw->textureTriangles = call.Array(TextureTriangles);
            if (TextureTriangles != null) call.Agree("texture_triangles", call.Rows(TextureTriangles, 3, "texture_triangles"), (long)raw->triangleCount);
            raw->materials = call.Records(Materials, sizeof(Native.Material));
            raw->materialCount = (ulong)call.Rows(Materials, 1, "materials");
            raw->triangleMaterials = call.Array(TriangleMaterials);
            if (TriangleMaterials != null) call.Agree("triangle_materials", call.Rows(TriangleMaterials, 1, "triangle_materials"), (long)raw->triangleCount);
            raw->images = call.Records(Images, sizeof(Native.Image));
            raw->imageCount = (ulong)call.Rows(Images, 1, "images");
        }
    }
}
