// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class VisitsRemovedVolume
    {
        internal VisitsRemovedVolume(double removedMl, double sdMl)
        {
            RemovedMl = removedMl;
            SdMl = sdMl;
        }

        /// <summary>may be left out; signed, mL.</summary>
        public double RemovedMl { get; private set; }
        /// <summary>may be left out; posterior deviation, mL.</summary>
        public double SdMl { get; private set; }
    }
}
