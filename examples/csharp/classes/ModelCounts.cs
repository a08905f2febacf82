// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class ModelCounts
    {
        internal ModelCounts(ulong vertexCount, ulong scalarModes, ulong vectorModes)
        {
            VertexCount = vertexCount;
            ScalarModes = scalarModes;
            VectorModes = vectorModes;
        }

        /// <summary>may be left out; #V.</summary>
        public ulong VertexCount { get; private set; }
        /// <summary>may be left out; columns of the scalar basis; 3 times as many deformation modes.</summary>
        public ulong ScalarModes { get; private set; }
        /// <summary>may be left out; modes trained on faces.</summary>
        public ulong VectorModes { get; private set; }
    }
}
