// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>mien_spectral_basis_options of the C interface.</summary>
    public sealed unsafe class SpectralBasisOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public SpectralBasisOptions()
        {
            Library.Need();
            var raw = default(Native.SpectralBasisOptions);
            Functions.mien_spectral_basis_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.SpectralBasisOptions));
            ModeCount = raw.modeCount;
            Mass = (Mass)raw.mass;
            Cotangents = (Cotangents)raw.cotangents;
        }

        /// <summary>1 to #V - 1; default 500</summary>
        public uint ModeCount { get; set; }
        /// <summary>MIEN_MASS_...; default mixed Voronoi</summary>
        public Mass Mass { get; set; }
        /// <summary>MIEN_COTANGENTS_...; default intrinsic Delaunay</summary>
        public Cotangents Cotangents { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.SpectralBasisOptions*)at;
            Functions.mien_spectral_basis_options_init(at, (UIntPtr)sizeof(Native.SpectralBasisOptions));
            raw->modeCount = ModeCount;
            raw->mass = (int)Mass;
            raw->cotangents = (int)Cotangents;
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.SpectralBasisOptions));
            Fill(call, at);
            var raw = (Native.SpectralBasisOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }
}
