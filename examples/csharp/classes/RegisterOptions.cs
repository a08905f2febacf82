// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>mien_register_options of the C interface.</summary>
    public sealed unsafe class RegisterOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public RegisterOptions()
        {
            Library.Need();
            var raw = default(Native.RegisterOptions);
            Functions.mien_register_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.RegisterOptions));
            Growth = (Growth)raw.growth;
            LandmarkSigmaMm = raw.landmarkSigmaMm;
            Start = (Start)raw.start;
            Units = (Units)raw.units;
            SkinWeights = raw.skinWeights;
            CloseGap = raw.closeGap;
            MaxScalarModes = raw.maxScalarModes;
            MaxPcaModes = raw.maxPcaModes;
            Iterations = raw.iterations;
            RejectBorder = raw.rejectBorder;
            SigmaStartMm = raw.sigmaStartMm;
            SigmaEndMm = raw.sigmaEndMm;
            MaxAngleDeg = raw.maxAngleDeg;
            StartRotation = Call.CopyOut(raw.startRotation, 9);
            StartTranslation = Call.CopyOut(raw.startTranslation, 3);
            StartScale = raw.startScale;
            ColorFeatures = raw.colorFeatures;
            UnitToMm = raw.unitToMm;
            LandmarkSides = (Sides)raw.landmarkSides;
            MaxDistanceMm = raw.maxDistanceMm;
            MutualMm = raw.mutualMm;
            SoftMm = raw.softMm;
        }

        /// <summary>MIEN_GROWTH_*; default constant, with annealed noise</summary>
        public Growth Growth { get; set; }
        /// <summary>landmark_count landmarks; null: none. Ones that contradict the others are left out; where all lie to one side of
        /// the face they are moved back onto it, and a note of the report says by how much</summary>
        public IReadOnlyList<ScanLandmark> Landmarks { get; set; }
        /// <summary>picking error per axis, &gt; 0; default 2</summary>
        public double LandmarkSigmaMm { get; set; }
        /// <summary>MIEN_START_*; default automatic</summary>
        public Start Start { get; set; }
        /// <summary>MIEN_UNITS_*; default detect</summary>
        public Units Units { get; set; }
        /// <summary>one weight in [0, 1] per scan vertex; count 0: all one</summary>
        public Values ScanWeights { get; set; }
        /// <summary>1: weigh scan vertices by the probability of skin colour; default 0</summary>
        public int SkinWeights { get; set; }
        /// <summary>1 (default): a smooth field closes what the modes leave open</summary>
        public int CloseGap { get; set; }
        /// <summary>of the model's kernel modes; default -1: all</summary>
        public int MaxScalarModes { get; set; }
        /// <summary>of the model's trained modes; default -1: all. Left out where the landmarks, or without them what the fit leaves
        /// of the surface, say that the face is outside of what they span (a note tells)</summary>
        public int MaxPcaModes { get; set; }
        /// <summary>1 to 10000; default 0: as many as the library thinks right</summary>
        public int Iterations { get; set; }
        /// <summary>1 (default): places on the scan's open border do not pull</summary>
        public int RejectBorder { get; set; }
        /// <summary>noise level of a surface point in the first round; default 3</summary>
        public double SigmaStartMm { get; set; }
        /// <summary>and in the last; default 0.5</summary>
        public double SigmaEndMm { get; set; }
        /// <summary>between the normals of a vertex and its place; default 60</summary>
        public double MaxAngleDeg { get; set; }
        /// <summary>row by row, template to scan; default identity</summary>
        public double[] StartRotation { get; set; }
        /// <summary>mm</summary>
        public double[] StartTranslation { get; set; }
        /// <summary>default 1</summary>
        public double StartScale { get; set; }
        /// <summary>1 (default): where the scan has vertex colours, its lips and brows hold the fit along the skin, and without
        /// landmarks eyes are seen to be shut; 0: by form alone. Needs landmarks of the 68-point scheme in the model
        /// (brow_*, mouth_outer_*, eye_*) or its zone "lips"</summary>
        public int ColorFeatures { get; set; }
        /// <summary>one unit of the scan in mm when it is known, e.g. 25.4; 0 (default): by `units` and by the landmarks, which
        /// settle it</summary>
        public double UnitToMm { get; set; }
        /// <summary>MIEN_SIDES_*; default refuse</summary>
        public Sides LandmarkSides { get; set; }
        /// <summary>places of the scan that are farther from their vertex do not pull, nearly so far ones less; default 0: as the
        /// noise level lets. Since 0.2</summary>
        public double MaxDistanceMm { get; set; }
        /// <summary>a place pulls a vertex while the vertex that is nearest to the place lies no farther than that from it; default
        /// 0: not asked. Below the template's spacing hardly any place pulls. Since 0.2</summary>
        public double MutualMm { get; set; }
        /// <summary>soft assignment: a vertex is pulled to the mean of the scan around its nearest place, weighed by a Gaussian of
        /// this deviation; default 0: to the place itself. Since 0.2</summary>
        public double SoftMm { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.RegisterOptions*)at;
            Functions.mien_register_options_init(at, (UIntPtr)sizeof(Native.RegisterOptions));
            raw->growth = (int)Growth;
            raw->landmarkSigmaMm = LandmarkSigmaMm;
            raw->start = (int)Start;
            raw->units = (int)Units;
            raw->scanWeights = call.Matrix(ScanWeights, 1, "scan_weights");
            raw->skinWeights = SkinWeights;
            raw->closeGap = CloseGap;
            raw->maxScalarModes = MaxScalarModes;
            raw->maxPcaModes = MaxPcaModes;
            raw->iterations = Iterations;
            raw->rejectBorder = RejectBorder;
            raw->sigmaStartMm = SigmaStartMm;
            raw->sigmaEndMm = SigmaEndMm;
            raw->maxAngleDeg = MaxAngleDeg;
            raw->startScale = StartScale;
            raw->colorFeatures = ColorFeatures;
            raw->unitToMm = UnitToMm;
            raw->landmarkSides = (int)LandmarkSides;
            raw->maxDistanceMm = MaxDistanceMm;
            raw->mutualMm = MutualMm;
            raw->softMm = SoftMm;
            raw->landmarks = call.Records(Landmarks, sizeof(Native.ScanLandmark));
            raw->landmarkCount = (ulong)call.Rows(Landmarks, 1, "landmarks");
            Call.CopyIn(StartRotation, raw->startRotation, 9, "start_rotation");
            Call.CopyIn(StartTranslation, raw->startTranslation, 3, "start_translation");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.RegisterOptions));
            Fill(call, at);
            var raw = (Native.RegisterOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }
}
