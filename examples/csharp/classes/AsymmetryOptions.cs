// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>mien_asymmetry_options of the C interface.</summary>
    public sealed unsafe class AsymmetryOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public AsymmetryOptions()
        {
            Library.Need();
            var raw = default(Native.AsymmetryOptions);
            Functions.mien_asymmetry_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.AsymmetryOptions));
            Plane = (MirrorBy)raw.plane;
            CorrelationLengthMm = raw.correlationLengthMm;
        }

        /// <summary>MIEN_MIRROR_BY_*; default by the surface</summary>
        public MirrorBy Plane { get; set; }
        /// <summary>zone_count zones of either side; null: the whole side only</summary>
        public IReadOnlyList<Zone> Zones { get; set; }
        /// <summary>of the template, vertices; may be left out unless the plane is found by them</summary>
        public Landmarks Landmarks { get; set; }
        /// <summary>#V, mm: deviation of each vertex along the normal, as MIEN_REGISTRATION_NORMAL_DEVIATION_MM tells it; count 0:
        /// not known, and no interval</summary>
        public Values NormalSd { get; set; }
        /// <summary>over which errors of the surface go together; default 4</summary>
        public double CorrelationLengthMm { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.AsymmetryOptions*)at;
            Functions.mien_asymmetry_options_init(at, (UIntPtr)sizeof(Native.AsymmetryOptions));
            raw->plane = (int)Plane;
            raw->normalSd = call.Matrix(NormalSd, 1, "normal_sd");
            raw->correlationLengthMm = CorrelationLengthMm;
            raw->zones = call.Records(Zones, sizeof(Native.Zone));
            raw->zoneCount = (ulong)call.Rows(Zones, 1, "zones");
            raw->landmarks = call.UseOrNull(Landmarks);
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.AsymmetryOptions));
            Fill(call, at);
            var raw = (Native.AsymmetryOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }
}
