// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>mien_series_options of the C interface.</summary>
    public sealed unsafe class SeriesOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public SeriesOptions()
        {
            Library.Need();
            var raw = default(Native.SeriesOptions);
            Functions.mien_series_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.SeriesOptions));
            Method = (Fit)raw.method;
            Pose = (Pose)raw.pose;
            ScanNoiseShare = raw.scanNoiseShare;
            NoiseMm2 = raw.noiseMm2;
            ExpectedChangeMm = raw.expectedChangeMm;
        }

        /// <summary>MIEN_FIT_MIXTURE (default) or MIEN_FIT_MAP</summary>
        public Fit Method { get; set; }
        /// <summary>MIEN_POSE_..., default MIEN_POSE_AUTO</summary>
        public Pose Pose { get; set; }
        /// <summary>what differs between scans beyond the model, as a share of the noise variance; default 0.01</summary>
        public double ScanNoiseShare { get; set; }
        /// <summary>noise variance; 0 (default): the model's own</summary>
        public double NoiseMm2 { get; set; }
        /// <summary>where the identity may change between scans; null: nowhere</summary>
        public uint[] ChangingVertices { get; set; }
        /// <summary>&gt; 0, default 5; without effect since 0.2: what lies there is no witness of the expression at all</summary>
        public double ExpectedChangeMm { get; set; }
        /// <summary>face_count x #V, face by face, &gt;= 0: 0 where a scan had no data; count 0: all one.</summary>
        public Values Weights { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.SeriesOptions*)at;
            Functions.mien_series_options_init(at, (UIntPtr)sizeof(Native.SeriesOptions));
            raw->method = (int)Method;
            raw->pose = (int)Pose;
            raw->scanNoiseShare = ScanNoiseShare;
            raw->noiseMm2 = NoiseMm2;
            raw->expectedChangeMm = ExpectedChangeMm;
            raw->weights = call.Matrix(Weights, 1, "weights");
            raw->changingVertices = call.Array(ChangingVertices);
            raw->changingCount = (ulong)call.Rows(ChangingVertices, 1, "changing_vertices");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.SeriesOptions));
            Fill(call, at);
            var raw = (Native.SeriesOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }
}
