// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class NeutralizationCounts
    {
        internal NeutralizationCounts(ulong vertexCount, uint identityModes, uint expressionModes)
        {
            VertexCount = vertexCount;
            IdentityModes = identityModes;
            ExpressionModes = expressionModes;
        }

        /// <summary>may be left out; #V.</summary>
        public ulong VertexCount { get; private set; }
        /// <summary>may be left out; those of the model.</summary>
        public uint IdentityModes { get; private set; }
        /// <summary>may be left out; those of the model.</summary>
        public uint ExpressionModes { get; private set; }
    }
}
