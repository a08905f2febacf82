// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class SpectralSplit
    {
        internal SpectralSplit(Mesh low, Mesh high)
        {
            Low = low;
            High = high;
        }

        /// <summary>may be left out; the low band's mesh.</summary>
        public Mesh Low { get; private set; }
        /// <summary>may be left out; the high band's mesh.</summary>
        public Mesh High { get; private set; }
    }
}
