// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class NetworkBands
    {
        internal NetworkBands(ulong lowCodeCount, long bandLimit)
        {
            LowCodeCount = lowCodeCount;
            BandLimit = bandLimit;
        }

        /// <summary>may be left out; numbers of the low band's code, which come first; all numbers of a network without bands.</summary>
        public ulong LowCodeCount { get; private set; }
        /// <summary>may be left out; modes of the low band; -1 for a network without bands.</summary>
        public long BandLimit { get; private set; }
    }
}
