// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>mien_batch_options of the C interface.</summary>
    public sealed unsafe class BatchOptions : Record
    {

        internal override void Fill(Call call, IntPtr at)
        {
            Functions.mien_batch_options_init(at, (UIntPtr)sizeof(Native.BatchOptions));
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.BatchOptions));
            Fill(call, at);
            var raw = (Native.BatchOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }
}
