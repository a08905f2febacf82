// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>mien_train_options of the C interface.</summary>
    public sealed unsafe class TrainOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public TrainOptions()
        {
            Library.Need();
            var raw = default(Native.TrainOptions);
            Functions.mien_train_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.TrainOptions));
            Method = (Train)raw.method;
            IdentityModes = raw.identityModes;
            ExpressionModes = raw.expressionModes;
            MaxIterations = raw.maxIterations;
            Passes = raw.passes;
            Lambda = raw.lambda;
            LambdaFactor = raw.lambdaFactor;
            AngleToleranceRad = raw.angleToleranceRad;
            NoiseMm2 = raw.noiseMm2;
        }

        /// <summary>MIEN_TRAIN_..., default MIEN_TRAIN_JPCA</summary>
        public Train Method { get; set; }
        /// <summary>1 to 4000; 0 (default since 0.2, 50 before): of 25, 50, 75 and 100 the fewest that serve people left out of the
        /// training</summary>
        public int IdentityModes { get; set; }
        /// <summary>1 to 4000; 0 (default): as above</summary>
        public int ExpressionModes { get; set; }
        /// <summary>QOJPCA; default 1000</summary>
        public int MaxIterations { get; set; }
        /// <summary>over the data, 1 to 50, default 4</summary>
        public int Passes { get; set; }
        /// <summary>QOJPCA; 0 (default): lambda_factor x the top eigenvalue of k XX'</summary>
        public double Lambda { get; set; }
        /// <summary>default 10</summary>
        public double LambdaFactor { get; set; }
        /// <summary>QOJPCA stops when no subspace turns farther; default 0.001</summary>
        public double AngleToleranceRad { get; set; }
        /// <summary>noise variance of the fits; 0 (default): by cross-validation</summary>
        public double NoiseMm2 { get; set; }
        /// <summary>posture: every face is aligned rigidly on these vertices (forehead, nose bridge), in training and in every fit;
        /// null: faces as they lie</summary>
        public uint[] StableVertices { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.TrainOptions*)at;
            Functions.mien_train_options_init(at, (UIntPtr)sizeof(Native.TrainOptions));
            raw->method = (int)Method;
            raw->identityModes = IdentityModes;
            raw->expressionModes = ExpressionModes;
            raw->maxIterations = MaxIterations;
            raw->passes = Passes;
            raw->lambda = Lambda;
            raw->lambdaFactor = LambdaFactor;
            raw->angleToleranceRad = AngleToleranceRad;
            raw->noiseMm2 = NoiseMm2;
            raw->stableVertices = call.Array(StableVertices);
            raw->stableCount = (ulong)call.Rows(StableVertices, 1, "stable_vertices");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.TrainOptions));
            Fill(call, at);
            var raw = (Native.TrainOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }
}
