// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>A named set of vertices of a surface, read in place and only during the call.</summary>
    public sealed unsafe class Zone : Record
    {
        public string Name { get; set; }
        /// <summary>vertex_count vertex numbers, repeated ones count once</summary>
        public uint[] Vertices { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.Zone*)at;
            raw->name = call.Text(Name);
            call.Required(Vertices, "vertices");
            raw->vertices = call.Array(Vertices);
            raw->vertexCount = (ulong)call.Rows(Vertices, 1, "vertices");
        }
    }
}
