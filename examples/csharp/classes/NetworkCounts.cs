// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class NetworkCounts
    {
        internal NetworkCounts(ulong vertexCount, ulong codeCount)
        {
            VertexCount = vertexCount;
            CodeCount = codeCount;
        }

        /// <summary>may be left out; #V.</summary>
        public ulong VertexCount { get; private set; }
        /// <summary>may be left out; numbers of a code.</summary>
        public ulong CodeCount { get; private set; }
    }
}
