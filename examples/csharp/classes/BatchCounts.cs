// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class BatchCounts
    {
        internal BatchCounts(uint scanCount, uint runCount)
        {
            ScanCount = scanCount;
            RunCount = runCount;
        }

        /// <summary>may be left out.</summary>
        public uint ScanCount { get; private set; }
        /// <summary>may be left out.</summary>
        public uint RunCount { get; private set; }
    }
}
