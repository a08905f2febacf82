// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>How far a fitted zone is expected to be from the truth: the mean distance of its vertices from the true ones,
    /// learned from simulated fits of many people, poses and troubles. Since 0.2</summary>
    public sealed unsafe class ExpectedError
    {
        /// <summary>MIEN_QUALITY_*, of the zone alone; doubtful at best where the fit failed or what speaks against the scan speaks
        /// against all of it (two surfaces over each other, inside out, no known unit)</summary>
        public Quality Quality { get; internal set; }
        public double ExpectedMm { get; internal set; }
        /// <summary>8 of 10 like fits are between low_mm and high_mm off</summary>
        public double LowMm { get; internal set; }
        public double HighMm { get; internal set; }
        /// <summary>0 to 1: share of the zone that the scan had no say in</summary>
        public double Unseen { get; internal set; }

        internal static ExpectedError Read(Call call, IntPtr at)
        {
            var raw = (Native.ExpectedError*)at;
            var made = new ExpectedError();
            made.Quality = (Quality)raw->quality;
            made.ExpectedMm = raw->expectedMm;
            made.LowMm = raw->lowMm;
            made.HighMm = raw->highMm;
            made.Unseen = raw->unseen;
            return made;
        }
    }
}
