// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class SpectralBasisCounts
    {
        internal SpectralBasisCounts(ulong vertexCount, ulong modeCount)
        {
            VertexCount = vertexCount;
            ModeCount = modeCount;
        }

        /// <summary>may be left out; #V.</summary>
        public ulong VertexCount { get; private set; }
        /// <summary>may be left out; k.</summary>
        public ulong ModeCount { get; private set; }
    }
}
