// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>mien_visits_options of the C interface.</summary>
    public sealed unsafe class VisitsOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public VisitsOptions()
        {
            Library.Need();
            var raw = default(Native.VisitsOptions);
            Functions.mien_visits_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.VisitsOptions));
            Pose = (Pose)raw.pose;
            NormalNoiseMm2 = raw.normalNoiseMm2;
            TangentialNoiseMm2 = raw.tangentialNoiseMm2;
        }

        /// <summary>MIEN_POSE_..., default MIEN_POSE_AUTO</summary>
        public Pose Pose { get; set; }
        /// <summary>variance of a fitted vertex along the skin's normal, with what no mode explains; default 0.3</summary>
        public double NormalNoiseMm2 { get; set; }
        /// <summary>along the skin: fits slide; default 30</summary>
        public double TangentialNoiseMm2 { get; set; }
        /// <summary>where the person may have changed: no witness of the expression; null: nowhere</summary>
        public uint[] TreatedVertices { get; set; }
        /// <summary>face_count x #V, face by face, &gt;= 0: 0 where a scan had no data; count 0: all one</summary>
        public Values Weights { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.VisitsOptions*)at;
            Functions.mien_visits_options_init(at, (UIntPtr)sizeof(Native.VisitsOptions));
            raw->pose = (int)Pose;
            raw->normalNoiseMm2 = NormalNoiseMm2;
            raw->tangentialNoiseMm2 = TangentialNoiseMm2;
            raw->weights = call.Matrix(Weights, 1, "weights");
            raw->treatedVertices = call.Array(TreatedVertices);
            raw->treatedCount = (ulong)call.Rows(TreatedVertices, 1, "treated_vertices");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.VisitsOptions));
            Fill(call, at);
            var raw = (Native.VisitsOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }
}
