// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class LandmarksCounts
    {
        internal LandmarksCounts(ulong count, ulong pickedCount)
        {
            Count = count;
            PickedCount = pickedCount;
        }

        /// <summary>may be left out.</summary>
        public ulong Count { get; private set; }
        /// <summary>may be left out.</summary>
        public ulong PickedCount { get; private set; }
    }
}
