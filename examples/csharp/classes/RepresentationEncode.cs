// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class RepresentationEncode
    {
        internal RepresentationEncode(double[] motion, double[] dst)
        {
            Motion = motion;
            Dst = dst;
        }

        /// <summary>may be left out; 12 float64: the rigid motion onto the mean, x -&gt; R x + t, as R row by row, then t in mm.
        /// mien_representation_decode() takes it back.</summary>
        public double[] Motion { get; private set; }
        /// <summary>rows of channel_count values.</summary>
        public double[] Dst { get; private set; }
    }
}
