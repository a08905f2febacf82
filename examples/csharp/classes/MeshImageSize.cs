// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class MeshImageSize
    {
        internal MeshImageSize(uint width, uint height)
        {
            Width = width;
            Height = height;
        }

        /// <summary>may be left out; pixels.</summary>
        public uint Width { get; private set; }
        /// <summary>may be left out; pixels.</summary>
        public uint Height { get; private set; }
    }
}
