// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class NetworkEncode
    {
        internal NetworkEncode(double[] motion, double[] dst)
        {
            Motion = motion;
            Dst = dst;
        }

        /// <summary>may be left out; 12 float64: the rigid motion onto the mean, x -&gt; R x + t, as R row by row, then t in mm.
        /// mien_network_decode() takes it back.</summary>
        public double[] Motion { get; private set; }
        /// <summary>values.</summary>
        public double[] Dst { get; private set; }
    }
}
