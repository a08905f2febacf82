// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>mien_score_options of the C interface.</summary>
    public sealed unsafe class ScoreOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public ScoreOptions()
        {
            Library.Need();
            var raw = default(Native.ScoreOptions);
            Functions.mien_score_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.ScoreOptions));
            Method = (Pls)raw.method;
            NumComponents = raw.numComponents;
            MaxComponents = raw.maxComponents;
            Folds = raw.folds;
            Seed = raw.seed;
            CurvatureShare = raw.curvatureShare;
            CurvatureRadiusMm = raw.curvatureRadiusMm;
            Lowest = raw.lowest;
            Highest = raw.highest;
            Focus = raw.focus;
            Features = (ScoreFeatures)raw.features;
        }

        /// <summary>MIEN_PLS_*; default NIPALS</summary>
        public Pls Method { get; set; }
        /// <summary>0 (default): by cross-validation and the one-standard-error rule</summary>
        public int NumComponents { get; set; }
        /// <summary>tried in cross-validation, 1 to 50; default 10</summary>
        public int MaxComponents { get; set; }
        /// <summary>over subjects; 0: leave one subject out; default 10</summary>
        public int Folds { get; set; }
        /// <summary>of the folds; default 1</summary>
        public ulong Seed { get; set; }
        /// <summary>total variance of the curvature features over that of the displacements; 0: none; default 0.1</summary>
        public double CurvatureShare { get; set; }
        /// <summary>of the fits that estimate curvature; default 8</summary>
        public double CurvatureRadiusMm { get; set; }
        /// <summary>range that predictions are cut to</summary>
        public double Lowest { get; set; }
        /// <summary>equal (default): none</summary>
        public double Highest { get; set; }
        /// <summary>of interest; null: all</summary>
        public uint[] ZoneVertices { get; set; }
        /// <summary>faces are aligned on these; null: on all, robustly</summary>
        public uint[] StableVertices { get; set; }
        /// <summary>1 (default): vertices count by how far they move with the score, found anew in each fold; 0: by their area alone</summary>
        public uint Focus { get; set; }
        /// <summary>MIEN_SCORE_FEATURES_*; default displacement and curvature. Since 0.2</summary>
        public ScoreFeatures Features { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.ScoreOptions*)at;
            Functions.mien_score_options_init(at, (UIntPtr)sizeof(Native.ScoreOptions));
            raw->method = (int)Method;
            raw->numComponents = NumComponents;
            raw->maxComponents = MaxComponents;
            raw->folds = Folds;
            raw->seed = Seed;
            raw->curvatureShare = CurvatureShare;
            raw->curvatureRadiusMm = CurvatureRadiusMm;
            raw->lowest = Lowest;
            raw->highest = Highest;
            raw->focus = Focus;
            raw->features = (int)Features;
            raw->zoneVertices = call.Array(ZoneVertices);
            raw->zoneCount = (ulong)call.Rows(ZoneVertices, 1, "zone_vertices");
            raw->stableVertices = call.Array(StableVertices);
            raw->stableCount = (ulong)call.Rows(StableVertices, 1, "stable_vertices");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.ScoreOptions));
            Fill(call, at);
            var raw = (Native.ScoreOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }
}
