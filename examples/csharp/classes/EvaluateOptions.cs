// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>mien_evaluate_options of the C interface.</summary>
    public sealed unsafe class EvaluateOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public EvaluateOptions()
        {
            Library.Need();
            var raw = default(Native.EvaluateOptions);
            Functions.mien_evaluate_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.EvaluateOptions));
            Method = (Fit)raw.method;
            MaxSweeps = raw.maxSweeps;
            AgainstMethod = (Fit)raw.againstMethod;
            AgainstMaxSweeps = raw.againstMaxSweeps;
        }

        /// <summary>MIEN_FIT_..., default MIEN_FIT_MIXTURE</summary>
        public Fit Method { get; set; }
        /// <summary>of the method; default 200</summary>
        public int MaxSweeps { get; set; }
        /// <summary>MIEN_FIT_... of the second model; default MIEN_FIT_ALTERNATING</summary>
        public Fit AgainstMethod { get; set; }
        /// <summary>default 3</summary>
        public int AgainstMaxSweeps { get; set; }
        /// <summary>second model to compare with; may be left out</summary>
        public ExpressionModel Against { get; set; }
        /// <summary>measure on these vertices only; null: all</summary>
        public uint[] ZoneVertices { get; set; }
        /// <summary>align every face rigidly to its target on these first; null: not</summary>
        public uint[] StableVertices { get; set; }
        /// <summary>absolute volumes to the neutral face are measured in these, too; null: none. Since 0.2</summary>
        public IReadOnlyList<Zone> VolumeZones { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.EvaluateOptions*)at;
            Functions.mien_evaluate_options_init(at, (UIntPtr)sizeof(Native.EvaluateOptions));
            raw->method = (int)Method;
            raw->maxSweeps = MaxSweeps;
            raw->againstMethod = (int)AgainstMethod;
            raw->againstMaxSweeps = AgainstMaxSweeps;
            raw->against = call.UseOrNull(Against);
            raw->zoneVertices = call.Array(ZoneVertices);
            raw->zoneCount = (ulong)call.Rows(ZoneVertices, 1, "zone_vertices");
            raw->stableVertices = call.Array(StableVertices);
            raw->stableCount = (ulong)call.Rows(StableVertices, 1, "stable_vertices");
            raw->volumeZones = call.Records(VolumeZones, sizeof(Native.Zone));
            raw->volumeZoneCount = (ulong)call.Rows(VolumeZones, 1, "volume_zones");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.EvaluateOptions));
            Fill(call, at);
            var raw = (Native.EvaluateOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }
}
