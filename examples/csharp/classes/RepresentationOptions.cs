// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>How to train; initialise with mien_representation_options_init().</summary>
    public sealed unsafe class RepresentationOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public RepresentationOptions()
        {
            Library.Need();
            var raw = default(Native.RepresentationOptions);
            Functions.mien_representation_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.RepresentationOptions));
            NeutralOnly = raw.neutralOnly;
        }

        /// <summary>1: only the faces marked neutral; default 0: all</summary>
        public int NeutralOnly { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.RepresentationOptions*)at;
            Functions.mien_representation_options_init(at, (UIntPtr)sizeof(Native.RepresentationOptions));
            raw->neutralOnly = NeutralOnly;
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.RepresentationOptions));
            Fill(call, at);
            var raw = (Native.RepresentationOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }
}
