// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class MeshMaterial
    {
        internal MeshMaterial(int image, double red, double green, double blue)
        {
            Image = image;
            Red = red;
            Green = green;
            Blue = blue;
        }

        /// <summary>may be left out; -1: none.</summary>
        public int Image { get; private set; }
        /// <summary>may be left out; 0 to 1.</summary>
        public double Red { get; private set; }
        /// <summary>may be left out; 0 to 1.</summary>
        public double Green { get; private set; }
        /// <summary>may be left out; 0 to 1.</summary>
        public double Blue { get; private set; }
    }
}
