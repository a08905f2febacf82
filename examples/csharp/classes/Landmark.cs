// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>A named vertex of the template.</summary>
    public sealed unsafe class Landmark : Record
    {
        public string Name { get; set; }
        public uint Vertex { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.Landmark*)at;
            raw->vertex = Vertex;
            raw->name = call.Text(Name);
        }
    }
}
