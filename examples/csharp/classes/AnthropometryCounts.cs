// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class AnthropometryCounts
    {
        internal AnthropometryCounts(ulong count, ulong knownCount)
        {
            Count = count;
            KnownCount = knownCount;
        }

        /// <summary>may be left out.</summary>
        public ulong Count { get; private set; }
        /// <summary>may be left out.</summary>
        public ulong KnownCount { get; private set; }
    }
}
