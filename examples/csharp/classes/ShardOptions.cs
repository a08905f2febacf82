// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>mien_shard_options of the C interface.</summary>
    public sealed unsafe class ShardOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public ShardOptions()
        {
            Library.Need();
            var raw = default(Native.ShardOptions);
            Functions.mien_shard_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.ShardOptions));
            Part = raw.part;
            PartCount = raw.partCount;
            MaxRank = raw.maxRank;
        }

        /// <summary>0 to part_count - 1, default 0: which subjects</summary>
        public int Part { get; set; }
        /// <summary>default 1: all subjects</summary>
        public int PartCount { get; set; }
        /// <summary>of identities and of expressions, default 512; parts with fewer subjects and faces are exact</summary>
        public int MaxRank { get; set; }
        /// <summary>as in mien_train_options; all parts of a dataset are aligned alike; null: faces as they lie</summary>
        public uint[] StableVertices { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.ShardOptions*)at;
            Functions.mien_shard_options_init(at, (UIntPtr)sizeof(Native.ShardOptions));
            raw->part = Part;
            raw->partCount = PartCount;
            raw->maxRank = MaxRank;
            raw->stableVertices = call.Array(StableVertices);
            raw->stableCount = (ulong)call.Rows(StableVertices, 1, "stable_vertices");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.ShardOptions));
            Fill(call, at);
            var raw = (Native.ShardOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }
}
