// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>One more kernel of a sum.</summary>
    public sealed unsafe class Kernel : Record
    {
        /// <summary>MIEN_KERNEL_..., not NONE</summary>
        public KernelKind Kind { get; set; }
        public double SigmaMm { get; set; }
        public double ScaleMm { get; set; }
        /// <summary>read for SURFACE_MATERN only</summary>
        public double Nu { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.Kernel*)at;
            raw->kind = (int)Kind;
            raw->sigmaMm = SigmaMm;
            raw->scaleMm = ScaleMm;
            raw->nu = Nu;
        }

        internal static Kernel Read(Call call, IntPtr at)
        {
            var raw = (Native.Kernel*)at;
            var made = new Kernel();
            made.Kind = (KernelKind)raw->kind;
            made.SigmaMm = raw->sigmaMm;
            made.ScaleMm = raw->scaleMm;
            made.Nu = raw->nu;
            return made;
        }
    }
}
