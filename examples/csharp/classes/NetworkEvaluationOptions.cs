// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What to evaluate; initialise with mien_network_evaluation_options_init().</summary>
    public sealed unsafe class NetworkEvaluationOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public NetworkEvaluationOptions()
        {
            Library.Need();
            var raw = default(Native.NetworkEvaluationOptions);
            Functions.mien_network_evaluation_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.NetworkEvaluationOptions));
            NeutralOnly = raw.neutralOnly;
            Perceptual = raw.perceptual;
        }

        /// <summary>1: only the faces marked neutral; default 0: all</summary>
        public int NeutralOnly { get; set; }
        /// <summary>1 (default): DAME and FMPD too; 0: distances alone</summary>
        public int Perceptual { get; set; }
        /// <summary>faces of these subjects; null: of all</summary>
        public int[] Subjects { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.NetworkEvaluationOptions*)at;
            Functions.mien_network_evaluation_options_init(at, (UIntPtr)sizeof(Native.NetworkEvaluationOptions));
            raw->neutralOnly = NeutralOnly;
            raw->perceptual = Perceptual;
            raw->subjects = call.Array(Subjects);
            raw->subjectCount = (ulong)call.Rows(Subjects, 1, "subjects");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.NetworkEvaluationOptions));
            Fill(call, at);
            var raw = (Native.NetworkEvaluationOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }
}
