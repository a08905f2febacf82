// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>mien_geodesic_options of the C interface.</summary>
    public sealed unsafe class GeodesicOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public GeodesicOptions()
        {
            Library.Need();
            var raw = default(Native.GeodesicOptions);
            Functions.mien_geodesic_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.GeodesicOptions));
            HeatBoundary = (Heat)raw.heatBoundary;
            HeatTimeFactor = raw.heatTimeFactor;
        }

        /// <summary>MIEN_HEAT_..., default NEUMANN</summary>
        public Heat HeatBoundary { get; set; }
        /// <summary>heat time in units of (mean edge)^2, 0.01 to 10000, default 4</summary>
        public double HeatTimeFactor { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.GeodesicOptions*)at;
            Functions.mien_geodesic_options_init(at, (UIntPtr)sizeof(Native.GeodesicOptions));
            raw->heatBoundary = (int)HeatBoundary;
            raw->heatTimeFactor = HeatTimeFactor;
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.GeodesicOptions));
            Fill(call, at);
            var raw = (Native.GeodesicOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }
}
