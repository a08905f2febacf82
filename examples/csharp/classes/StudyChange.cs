// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What changed in one zone from one visit to another. Set struct_size first.</summary>
    public sealed unsafe class StudyChange
    {
        /// <summary>MIEN_STUDY_*: why there is no deviation</summary>
        public StudyKind Unknown { get; internal set; }
        /// <summary>gained and lost together; positive: gained</summary>
        public StudyValue SignedMl { get; internal set; }
        /// <summary>&gt;= 0</summary>
        public StudyValue GainedMl { get; internal set; }
        /// <summary>&lt;= 0</summary>
        public StudyValue LostMl { get; internal set; }
        /// <summary>gained without lost</summary>
        public StudyValue AbsoluteMl { get; internal set; }
        public StudyValue AreaChangeMm2 { get; internal set; }
        /// <summary>along the normals of the first face; positive: outside</summary>
        public StudyValue MeanDistanceMm { get; internal set; }
        /// <summary>of signed_ml.sd: by the fitted surfaces</summary>
        public double SurfaceSdMl { get; internal set; }
        /// <summary>by the alignment on the stable zone</summary>
        public double AlignmentSdMl { get; internal set; }
        /// <summary>by the error common to all vertices</summary>
        public double BiasSdMl { get; internal set; }
        /// <summary>by what taking the expressions off leaves open</summary>
        public double ExpressionSdMl { get; internal set; }
        /// <summary>what the expressions accounted for, signed</summary>
        public double ExpressionRemovedMl { get; internal set; }
        /// <summary>of the zone's area, in both visits; NaN: not told</summary>
        public double SeenShare { get; internal set; }
        public double AreaBeforeMm2 { get; internal set; }
        public double AreaAfterMm2 { get; internal set; }
        /// <summary>1: signed_ml reaches its limit of detection, 0: below it, -1: no limit known</summary>
        public int Detected { get; internal set; }

        internal static StudyChange Read(Call call, IntPtr at)
        {
            var raw = (Native.StudyChange*)at;
            var made = new StudyChange();
            made.Unknown = (StudyKind)raw->unknown;
            made.SignedMl = StudyValue.Read(call, (IntPtr)(&raw->signedMl));
            made.GainedMl = StudyValue.Read(call, (IntPtr)(&raw->gainedMl));
            made.LostMl = StudyValue.Read(call, (IntPtr)(&raw->lostMl));
            made.AbsoluteMl = StudyValue.Read(call, (IntPtr)(&raw->absoluteMl));
            made.AreaChangeMm2 = StudyValue.Read(call, (IntPtr)(&raw->areaChangeMm2));
            made.MeanDistanceMm = StudyValue.Read(call, (IntPtr)(&raw->meanDistanceMm));
            made.SurfaceSdMl = raw->surfaceSdMl;
            made.AlignmentSdMl = raw->alignmentSdMl;
            made.BiasSdMl = raw->biasSdMl;
            made.ExpressionSdMl = raw->expressionSdMl;
            made.ExpressionRemovedMl = raw->expressionRemovedMl;
            made.SeenShare = raw->seenShare;
            made.AreaBeforeMm2 = raw->areaBeforeMm2;
            made.AreaAfterMm2 = raw->areaAfterMm2;
            made.Detected = raw->detected;
            return made;
        }
    }
}
