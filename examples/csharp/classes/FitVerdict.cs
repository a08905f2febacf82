// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>The verdict on a fit; the reasons in words are in the JSON report. The quality is that of the error expected of
    /// the whole face (mien_registration_get_expected_error()), doubtful at best where a zone has failed.</summary>
    public sealed unsafe class FitVerdict
    {
        /// <summary>MIEN_QUALITY_*</summary>
        public Quality Quality { get; internal set; }
        /// <summary>share of the template's vertices with a scan beside them</summary>
        public double Coverage { get; internal set; }
        /// <summary>of those: share that lies on the scan</summary>
        public double InlierShare { get; internal set; }
        public double MeanResidualMm { get; internal set; }
        /// <summary>0 without landmarks</summary>
        public double LandmarkRmsMm { get; internal set; }
        /// <summary>fitted size over template size</summary>
        public double SizeRatio { get; internal set; }
        /// <summary>of the coefficients, in standard deviations of the prior</summary>
        public double MeanDeviation { get; internal set; }
        /// <summary>what one unit of the scan was taken for</summary>
        public double UnitToMm { get; internal set; }
        public int LandmarksUsed { get; internal set; }
        public int LandmarksRejected { get; internal set; }
        public int FlippedTriangles { get; internal set; }
        public int SelfIntersections { get; internal set; }

        internal static FitVerdict Read(Call call, IntPtr at)
        {
            var raw = (Native.FitVerdict*)at;
            var made = new FitVerdict();
            made.Quality = (Quality)raw->quality;
            made.Coverage = raw->coverage;
            made.InlierShare = raw->inlierShare;
            made.MeanResidualMm = raw->meanResidualMm;
            made.LandmarkRmsMm = raw->landmarkRmsMm;
            made.SizeRatio = raw->sizeRatio;
            made.MeanDeviation = raw->meanDeviation;
            made.UnitToMm = raw->unitToMm;
            made.LandmarksUsed = raw->landmarksUsed;
            made.LandmarksRejected = raw->landmarksRejected;
            made.FlippedTriangles = raw->flippedTriangles;
            made.SelfIntersections = raw->selfIntersections;
            return made;
        }
    }
}
