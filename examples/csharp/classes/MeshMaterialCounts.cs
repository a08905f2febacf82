// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class MeshMaterialCounts
    {
        internal MeshMaterialCounts(ulong materialCount, ulong imageCount)
        {
            MaterialCount = materialCount;
            ImageCount = imageCount;
        }

        /// <summary>may be left out.</summary>
        public ulong MaterialCount { get; private set; }
        /// <summary>may be left out.</summary>
        public ulong ImageCount { get; private set; }
    }
}
