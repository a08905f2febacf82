// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class MeasureScanVolume
    {
        internal MeasureScanVolume(double coverage, Measurement @out)
        {
            Coverage = coverage;
            Out = @out;
        }

        /// <summary>may be left out; share of before's area that had a partner, 0 to 1.</summary>
        public double Coverage { get; private set; }
        /// <summary>the measurement.</summary>
        public Measurement Out { get; private set; }
    }
}
