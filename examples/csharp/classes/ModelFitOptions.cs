// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>mien_model_fit_options of the C interface.</summary>
    public sealed unsafe class ModelFitOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public ModelFitOptions()
        {
            Library.Need();
            var raw = default(Native.ModelFitOptions);
            Functions.mien_model_fit_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.ModelFitOptions));
            Align = raw.align;
            RidgeMm2 = raw.ridgeMm2;
            ScalarModes = raw.scalarModes;
            VectorModes = raw.vectorModes;
        }

        /// <summary>1: move the target rigidly onto the model's mean; default 0</summary>
        public int Align { get; set; }
        /// <summary>rho: variance of the target's noise, mm^2, &gt;= 0; default 1</summary>
        public double RidgeMm2 { get; set; }
        /// <summary>one per vertex of the target, &gt;= 0, which enter squared; count 0: all one</summary>
        public Values Weights { get; set; }
        /// <summary>the first of them, the others stay 0; -1 (default): all</summary>
        public int ScalarModes { get; set; }
        /// <summary>the first of them, the others stay 0; -1 (default): all</summary>
        public int VectorModes { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.ModelFitOptions*)at;
            Functions.mien_model_fit_options_init(at, (UIntPtr)sizeof(Native.ModelFitOptions));
            raw->align = Align;
            raw->ridgeMm2 = RidgeMm2;
            raw->weights = call.Matrix(Weights, 1, "weights");
            raw->scalarModes = ScalarModes;
            raw->vectorModes = VectorModes;
        }
    }
}
