// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>mien_measure_options of the C interface.</summary>
    public sealed unsafe class MeasureOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public MeasureOptions()
        {
            Library.Need();
            var raw = default(Native.MeasureOptions);
            Functions.mien_measure_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.MeasureOptions));
            SkipBorders = raw.skipBorders;
            CorrelationLengthMm = raw.correlationLengthMm;
            AlignmentRotationSdRad = raw.alignmentRotationSdRad;
            AlignmentTranslationSdMm = raw.alignmentTranslationSdMm;
            AlignmentCentre = Call.CopyOut(raw.alignmentCentre, 3);
            CommonBiasMm = raw.commonBiasMm;
            LimitOfDetectionMl = raw.limitOfDetectionMl;
            MaxDistanceMm = raw.maxDistanceMm;
        }

        /// <summary>surfaces not in correspondence: 1 (default) leaves out places whose partner lies on an open border, where
        /// nothing is known</summary>
        public int SkipBorders { get; set; }
        /// <summary>zone_count zones; null: the whole face only</summary>
        public IReadOnlyList<Zone> Zones { get; set; }
        /// <summary>#V, mm: deviation of each vertex along the normal, as MIEN_REGISTRATION_NORMAL_DEVIATION_MM tells it; count 0:
        /// exact. Without that of either face there is no interval (since 0.2), whatever the alignment's</summary>
        public Values BeforeSd { get; set; }
        public Values AfterSd { get; set; }
        /// <summary>over which errors of a surface go together; default 4, in 0.1: 10</summary>
        public double CorrelationLengthMm { get; set; }
        /// <summary>of the after face against the before face; default 0</summary>
        public double AlignmentRotationSdRad { get; set; }
        /// <summary>default 0</summary>
        public double AlignmentTranslationSdMm { get; set; }
        /// <summary>mm; what the alignment turns about, e.g. the stable zone's centre</summary>
        public double[] AlignmentCentre { get; set; }
        /// <summary>error common to all vertices; default 0</summary>
        public double CommonBiasMm { get; set; }
        /// <summary>smaller changes are marked as below it; default 0: unknown</summary>
        public double LimitOfDetectionMl { get; set; }
        /// <summary>surfaces not in correspondence: farther partners are none; default 0: no limit</summary>
        public double MaxDistanceMm { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.MeasureOptions*)at;
            Functions.mien_measure_options_init(at, (UIntPtr)sizeof(Native.MeasureOptions));
            raw->skipBorders = SkipBorders;
            raw->beforeSd = call.Matrix(BeforeSd, 1, "before_sd");
            raw->afterSd = call.Matrix(AfterSd, 1, "after_sd");
            raw->correlationLengthMm = CorrelationLengthMm;
            raw->alignmentRotationSdRad = AlignmentRotationSdRad;
            raw->alignmentTranslationSdMm = AlignmentTranslationSdMm;
            raw->commonBiasMm = CommonBiasMm;
            raw->limitOfDetectionMl = LimitOfDetectionMl;
            raw->maxDistanceMm = MaxDistanceMm;
            raw->zones = call.Records(Zones, sizeof(Native.Zone));
            raw->zoneCount = (ulong)call.Rows(Zones, 1, "zones");
            Call.CopyIn(AlignmentCentre, raw->alignmentCentre, 3, "alignment_centre");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.MeasureOptions));
            Fill(call, at);
            var raw = (Native.MeasureOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }
}
