// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>mien_tune_options of the C interface.</summary>
    public sealed unsafe class TuneOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public TuneOptions()
        {
            Library.Need();
            var raw = default(Native.TuneOptions);
            Functions.mien_tune_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.TuneOptions));
            Kernel = (KernelKind)raw.kernel;
            ScaleMm = raw.scaleMm;
            Nu = raw.nu;
            Rho = raw.rho;
            Levels = raw.levels;
            NumModes = raw.numModes;
            MaxSubjects = raw.maxSubjects;
        }

        /// <summary>MIEN_KERNEL_..., not NONE; default GEODESIC_SE</summary>
        public KernelKind Kernel { get; set; }
        /// <summary>sigma_count length scales to try, each &gt; 0</summary>
        public double[] SigmasMm { get; set; }
        /// <summary>&gt; 0, default 1</summary>
        public double ScaleMm { get; set; }
        /// <summary>default 2</summary>
        public double Nu { get; set; }
        /// <summary>weight of the prior in the fits, &gt;= 0, default 5</summary>
        public double Rho { get; set; }
        /// <summary>1 to 12, default 1</summary>
        public int Levels { get; set; }
        /// <summary>deformation modes, &gt;= 3, default 999</summary>
        public int NumModes { get; set; }
        /// <summary>expression_count names: these faces only; null: all</summary>
        public IReadOnlyList<string> Expressions { get; set; }
        /// <summary>of the dataset's order; 0 (default): all</summary>
        public int MaxSubjects { get; set; }
        /// <summary>scale_count scales to try with each sigma, each &gt; 0; null: scale_mm alone</summary>
        public double[] ScalesMm { get; set; }
        /// <summary>level_count numbers of levels to try with each of those, each 1 to 12; null: `levels` alone</summary>
        public int[] LevelCounts { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.TuneOptions*)at;
            Functions.mien_tune_options_init(at, (UIntPtr)sizeof(Native.TuneOptions));
            raw->kernel = (int)Kernel;
            raw->scaleMm = ScaleMm;
            raw->nu = Nu;
            raw->rho = Rho;
            raw->levels = Levels;
            raw->numModes = NumModes;
            raw->maxSubjects = MaxSubjects;
            call.Required(SigmasMm, "sigmas_mm");
            raw->sigmasMm = call.Array(SigmasMm);
            raw->sigmaCount = (ulong)call.Rows(SigmasMm, 1, "sigmas_mm");
            raw->expressions = call.Texts(Expressions);
            raw->expressionCount = (uint)call.Rows(Expressions, 1, "expressions");
            raw->scalesMm = call.Array(ScalesMm);
            raw->scaleCount = (ulong)call.Rows(ScalesMm, 1, "scales_mm");
            raw->levelCounts = call.Array(LevelCounts);
            raw->levelCount = (ulong)call.Rows(LevelCounts, 1, "level_counts");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.TuneOptions));
            Fill(call, at);
            var raw = (Native.TuneOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }
}
