// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>A material of a mesh, read in place and only during the call.</summary>
    public sealed unsafe class Material : Record
    {
        /// <summary>UTF-8; may be left out</summary>
        public string Name { get; set; }
        /// <summary>number of the base colour's image, -1: none</summary>
        public int Image { get; set; }
        /// <summary>0 to 1; an image is times this</summary>
        public double Red { get; set; }
        public double Green { get; set; }
        public double Blue { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.Material*)at;
            raw->image = Image;
            raw->red = Red;
            raw->green = Green;
            raw->blue = Blue;
            raw->name = call.TextOrNull(Name);
        }
    }
}
