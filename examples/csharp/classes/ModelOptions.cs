// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>mien_model_options of the C interface.</summary>
    public sealed unsafe class ModelOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public ModelOptions()
        {
            Library.Need();
            var raw = default(Native.ModelOptions);
            Functions.mien_model_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.ModelOptions));
            Kernel = (KernelKind)raw.kernel;
            SigmaMm = raw.sigmaMm;
            ScaleMm = raw.scaleMm;
            Nu = raw.nu;
            Levels = raw.levels;
            NumModes = raw.numModes;
            Tolerance = raw.tolerance;
            NumControlPoints = raw.numControlPoints;
            MirrorSymmetric = raw.mirrorSymmetric;
            MirrorCorrelation = raw.mirrorCorrelation;
            EigenvalueThreshold = raw.eigenvalueThreshold;
            HeatTimeFactor = raw.heatTimeFactor;
            HeatBoundary = (Heat)raw.heatBoundary;
            PcaModes = raw.pcaModes;
            PcaVariance = raw.pcaVariance;
            PcaAllExpressions = raw.pcaAllExpressions;
            PcaAlign = raw.pcaAlign;
        }

        /// <summary>MIEN_KERNEL_..., default GEODESIC_SE</summary>
        public KernelKind Kernel { get; set; }
        /// <summary>length scale; full width for BSPLINE; &gt; 0, default 20</summary>
        public double SigmaMm { get; set; }
        /// <summary>standard deviation of a displacement's coordinate; &gt; 0, default 3</summary>
        public double ScaleMm { get; set; }
        /// <summary>smoothness of SURFACE_MATERN, 0.1 to 20, default 2</summary>
        public double Nu { get; set; }
        /// <summary>1 to 12, default 1: sum of kernels with sigma, 2 sigma, 4 sigma, ...</summary>
        public int Levels { get; set; }
        /// <summary>deformation modes at most, 3 per scalar mode; &gt;= 3, default 999</summary>
        public int NumModes { get; set; }
        /// <summary>kernel_count kernels added to the one above; may be left out</summary>
        public IReadOnlyList<Kernel> Kernels { get; set; }
        /// <summary>&gt; 0: stop once this share of the variance is left; default 0</summary>
        public double Tolerance { get; set; }
        /// <summary>default 0: max(1000, num_modes), never more than #V</summary>
        public int NumControlPoints { get; set; }
        /// <summary>1: modes purely even or odd about the plane x = 0; default 0</summary>
        public int MirrorSymmetric { get; set; }
        /// <summary>0 to 1: how much both sides are expected to move alike; default 0</summary>
        public double MirrorCorrelation { get; set; }
        /// <summary>eigenvalues among the control points below this share of the largest are dropped; 0 &lt; x &lt; 1, default
        /// 0.0001</summary>
        public double EigenvalueThreshold { get; set; }
        /// <summary>heat time in units of (mean edge)^2, 0.01 to 10000, default 4</summary>
        public double HeatTimeFactor { get; set; }
        /// <summary>MIEN_HEAT_..., default NEUMANN</summary>
        public Heat HeatBoundary { get; set; }
        /// <summary>default 0: as many as pca_variance asks for</summary>
        public int PcaModes { get; set; }
        /// <summary>UTF-8 path of a dataset of registered faces, or null: adds their mean and principal modes; the kernel then
        /// stands for what they leave over: of three people or more, for what they leave of people left out (info
        /// pca_left_out_mm of the model's JSON)</summary>
        public string PcaDataset { get; set; }
        /// <summary>share of the faces' variance kept, 0 to 1, default 0.999</summary>
        public double PcaVariance { get; set; }
        /// <summary>1 (default): all faces, 0: neutral ones</summary>
        public int PcaAllExpressions { get; set; }
        /// <summary>1: move each face rigidly onto the template first; default 0</summary>
        public int PcaAlign { get; set; }
        /// <summary>#V x 1 factors &gt;= 0 of scale_mm; count 0: one everywhere</summary>
        public Values ScalePerVertex { get; set; }
        /// <summary>landmark_count; may be left out</summary>
        public IReadOnlyList<Landmark> Landmarks { get; set; }
        /// <summary>zone_count; may be left out</summary>
        public IReadOnlyList<Zone> Zones { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.ModelOptions*)at;
            Functions.mien_model_options_init(at, (UIntPtr)sizeof(Native.ModelOptions));
            raw->kernel = (int)Kernel;
            raw->sigmaMm = SigmaMm;
            raw->scaleMm = ScaleMm;
            raw->nu = Nu;
            raw->levels = Levels;
            raw->numModes = NumModes;
            raw->tolerance = Tolerance;
            raw->numControlPoints = NumControlPoints;
            raw->mirrorSymmetric = MirrorSymmetric;
            raw->mirrorCorrelation = MirrorCorrelation;
            raw->eigenvalueThreshold = EigenvalueThreshold;
            raw->heatTimeFactor = HeatTimeFactor;
            raw->heatBoundary = (int)HeatBoundary;
            raw->pcaModes = PcaModes;
            raw->pcaVariance = PcaVariance;
            raw->pcaAllExpressions = PcaAllExpressions;
            raw->pcaAlign = PcaAlign;
            raw->scalePerVertex = call.Matrix(ScalePerVertex, 1, "scale_per_vertex");
            raw->kernels = call.Records(Kernels, sizeof(Native.Kernel));
            raw->kernelCount = (ulong)call.Rows(Kernels, 1, "kernels");
            raw->pcaDataset = call.TextOrNull(PcaDataset);
            raw->landmarks = call.Records(Landmarks, sizeof(Native.Landmark));
            raw->landmarkCount = (ulong)call.Rows(Landmarks, 1, "landmarks");
            raw->zones = call.Records(Zones, sizeof(Native.Zone));
            raw->zoneCount = (ulong)call.Rows(Zones, 1, "zones");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.ModelOptions));
            Fill(call, at);
            var raw = (Native.ModelOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }
}
