// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>mien_blendshape_options of the C interface.</summary>
    public sealed unsafe class BlendshapeOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public BlendshapeOptions()
        {
            Library.Need();
            var raw = default(Native.BlendshapeOptions);
            Functions.mien_blendshape_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.BlendshapeOptions));
            Ridge = raw.ridge;
        }

        /// <summary>of the kernel's mean diagonal; default 0: by leave-one-out error</summary>
        public double Ridge { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.BlendshapeOptions*)at;
            Functions.mien_blendshape_options_init(at, (UIntPtr)sizeof(Native.BlendshapeOptions));
            raw->ridge = Ridge;
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.BlendshapeOptions));
            Fill(call, at);
            var raw = (Native.BlendshapeOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }
}
