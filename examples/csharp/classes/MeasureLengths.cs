// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class MeasureLengths
    {
        internal MeasureLengths(double[] straightMm, double[] geodesicMm)
        {
            StraightMm = straightMm;
            GeodesicMm = geodesicMm;
        }

        /// <summary>pair_count values.</summary>
        public double[] StraightMm { get; private set; }
        /// <summary>pair_count values; by the heat method, within about one percent; infinite where no surface joins the two.</summary>
        public double[] GeodesicMm { get; private set; }
    }
}
