// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class StudyCounts
    {
        internal StudyCounts(uint visitCount, uint zoneCount)
        {
            VisitCount = visitCount;
            ZoneCount = zoneCount;
        }

        /// <summary>may be left out.</summary>
        public uint VisitCount { get; private set; }
        /// <summary>may be left out.</summary>
        public uint ZoneCount { get; private set; }
    }
}
