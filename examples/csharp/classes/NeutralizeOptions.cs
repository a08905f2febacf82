// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>mien_neutralize_options of the C interface.</summary>
    public sealed unsafe class NeutralizeOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public NeutralizeOptions()
        {
            Library.Need();
            var raw = default(Native.NeutralizeOptions);
            Functions.mien_neutralize_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.NeutralizeOptions));
            Method = (Fit)raw.method;
            MaxSweeps = raw.maxSweeps;
            Uncertainty = raw.uncertainty;
            Pose = (Pose)raw.pose;
            ToleranceMm = raw.toleranceMm;
            NoiseMm2 = raw.noiseMm2;
            DecayMm = raw.decayMm;
            TreatedMarginMm = raw.treatedMarginMm;
        }

        /// <summary>MIEN_FIT_..., default MIEN_FIT_MIXTURE</summary>
        public Fit Method { get; set; }
        /// <summary>alternating; 1 to 100000, default 200</summary>
        public int MaxSweeps { get; set; }
        /// <summary>1: compute the deviation per vertex; default 0</summary>
        public int Uncertainty { get; set; }
        /// <summary>MIEN_POSE_..., default MIEN_POSE_AUTO</summary>
        public Pose Pose { get; set; }
        /// <summary>alternating: stop when a sweep moves less; default 1e-6</summary>
        public double ToleranceMm { get; set; }
        /// <summary>0 (default): the model's own</summary>
        public double NoiseMm2 { get; set; }
        /// <summary>how far a displacement reaches beyond the model's rim; default 25</summary>
        public double DecayMm { get; set; }
        /// <summary>#V x 1, &gt;= 0: 0 where the scan had no data; count 0: all one</summary>
        public Values Weights { get; set; }
        /// <summary>treated_count vertices where the person may have been changed: no witness of expression or pose, so that filler
        /// in a lip stays on the face and is not taken for a rolled lip; null: none. Since 0.2</summary>
        public uint[] Treated { get; set; }
        /// <summary>around them, no witness either; treatments spread; 0 to 100, default 10</summary>
        public double TreatedMarginMm { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.NeutralizeOptions*)at;
            Functions.mien_neutralize_options_init(at, (UIntPtr)sizeof(Native.NeutralizeOptions));
            raw->method = (int)Method;
            raw->maxSweeps = MaxSweeps;
            raw->uncertainty = Uncertainty;
            raw->pose = (int)Pose;
            raw->toleranceMm = ToleranceMm;
            raw->noiseMm2 = NoiseMm2;
            raw->decayMm = DecayMm;
            raw->weights = call.Matrix(Weights, 1, "weights");
            raw->treatedMarginMm = TreatedMarginMm;
            raw->treated = call.Array(Treated);
            raw->treatedCount = (ulong)call.Rows(Treated, 1, "treated");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.NeutralizeOptions));
            Fill(call, at);
            var raw = (Native.NeutralizeOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }
}
