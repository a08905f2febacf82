// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class MeshCounts
    {
        internal MeshCounts(ulong vertexCount, ulong triangleCount)
        {
            VertexCount = vertexCount;
            TriangleCount = triangleCount;
        }

        /// <summary>may be left out; #V.</summary>
        public ulong VertexCount { get; private set; }
        /// <summary>may be left out; #F.</summary>
        public ulong TriangleCount { get; private set; }
    }
}
