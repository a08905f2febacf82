// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class RepresentationCounts
    {
        internal RepresentationCounts(ulong vertexCount, ulong channelCount)
        {
            VertexCount = vertexCount;
            ChannelCount = channelCount;
        }

        /// <summary>may be left out; #V.</summary>
        public ulong VertexCount { get; private set; }
        /// <summary>may be left out; 3, or 9 for deformations.</summary>
        public ulong ChannelCount { get; private set; }
    }
}
