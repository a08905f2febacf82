// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Distances of one zone, mm, weighted with area.</summary>
    public sealed unsafe class ZoneDistance
    {
        /// <summary>along the normal of the before face; positive: outside</summary>
        public double MeanSignedMm { get; internal set; }
        public double SdSignedMm { get; internal set; }
        /// <summary>of the signed ones</summary>
        public double MeanAbsoluteMm { get; internal set; }
        /// <summary>of the lengths</summary>
        public double RmsMm { get; internal set; }
        public double MeanLengthMm { get; internal set; }
        public double MedianLengthMm { get; internal set; }
        public double P95LengthMm { get; internal set; }
        public double MaxLengthMm { get; internal set; }
        /// <summary>vertices that had a partner</summary>
        public ulong VertexCount { get; internal set; }

        internal static ZoneDistance Read(Call call, IntPtr at)
        {
            var raw = (Native.ZoneDistance*)at;
            var made = new ZoneDistance();
            made.MeanSignedMm = raw->meanSignedMm;
            made.SdSignedMm = raw->sdSignedMm;
            made.MeanAbsoluteMm = raw->meanAbsoluteMm;
            made.RmsMm = raw->rmsMm;
            made.MeanLengthMm = raw->meanLengthMm;
            made.MedianLengthMm = raw->medianLengthMm;
            made.P95LengthMm = raw->p95LengthMm;
            made.MaxLengthMm = raw->maxLengthMm;
            made.VertexCount = raw->vertexCount;
            return made;
        }
    }
}
