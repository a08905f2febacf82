// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Volume of one zone, mL. signed = positive + negative, absolute = positive - negative; positive: the after face
    /// lies outside. NaN where a number is not known.</summary>
    public sealed unsafe class ZoneVolume
    {
        /// <summary>1: |signed| reaches the limit of detection, 0: below it, -1: no limit given</summary>
        public int Detected { get; internal set; }
        public double SignedMl { get; internal set; }
        /// <summary>&gt;= 0</summary>
        public double PositiveMl { get; internal set; }
        /// <summary>&lt;= 0</summary>
        public double NegativeMl { get; internal set; }
        public double AbsoluteMl { get; internal set; }
        /// <summary>of signed_ml; NaN when no deviation was given</summary>
        public double SdMl { get; internal set; }
        /// <summary>95 % interval of signed_ml</summary>
        public double Low95Ml { get; internal set; }
        public double High95Ml { get; internal set; }
        public double AreaBeforeMm2 { get; internal set; }
        /// <summary>NaN for surfaces not in correspondence</summary>
        public double AreaAfterMm2 { get; internal set; }

        internal static ZoneVolume Read(Call call, IntPtr at)
        {
            var raw = (Native.ZoneVolume*)at;
            var made = new ZoneVolume();
            made.Detected = raw->detected;
            made.SignedMl = raw->signedMl;
            made.PositiveMl = raw->positiveMl;
            made.NegativeMl = raw->negativeMl;
            made.AbsoluteMl = raw->absoluteMl;
            made.SdMl = raw->sdMl;
            made.Low95Ml = raw->low95Ml;
            made.High95Ml = raw->high95Ml;
            made.AreaBeforeMm2 = raw->areaBeforeMm2;
            made.AreaAfterMm2 = raw->areaAfterMm2;
            return made;
        }
    }
}
