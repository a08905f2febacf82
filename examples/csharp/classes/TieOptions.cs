// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>mien_tie_options of the C interface.</summary>
    public sealed unsafe class TieOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public TieOptions()
        {
            Library.Need();
            var raw = default(Native.TieOptions);
            Functions.mien_tie_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.TieOptions));
            MaxSlideMm = raw.maxSlideMm;
            LeastShare = raw.leastShare;
        }

        /// <summary>0.1 to 20; default 6: no place moves farther</summary>
        public double MaxSlideMm { get; set; }
        /// <summary>0 to 1; default 0.2: of the skin that both visits see, the share on which their pictures must agree, or nothing
        /// moves</summary>
        public double LeastShare { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.TieOptions*)at;
            Functions.mien_tie_options_init(at, (UIntPtr)sizeof(Native.TieOptions));
            raw->maxSlideMm = MaxSlideMm;
            raw->leastShare = LeastShare;
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.TieOptions));
            Fill(call, at);
            var raw = (Native.TieOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }
}
