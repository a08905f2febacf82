// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What a reading takes off inside the treated zone (without its margin).</summary>
    public sealed unsafe class ZoneReading
    {
        /// <summary>1: the two readings see another expression and another volume</summary>
        public int Differ { get; internal set; }
        /// <summary>of the likeliest expression, which the JSON names</summary>
        public double Probability { get; internal set; }
        /// <summary>root mean square over the zone</summary>
        public double RemovedMm { get; internal set; }
        /// <summary>by which the zone stood out through the expression, to first order</summary>
        public double RemovedMl { get; internal set; }

        internal static ZoneReading Read(Call call, IntPtr at)
        {
            var raw = (Native.ZoneReading*)at;
            var made = new ZoneReading();
            made.Differ = raw->differ;
            made.Probability = raw->probability;
            made.RemovedMm = raw->removedMm;
            made.RemovedMl = raw->removedMl;
            return made;
        }
    }
}
