// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Errors of neutralization over a dataset. Immutable: share freely between threads.</summary>
    public sealed unsafe class Evaluation : NativeObject
    {
        internal Evaluation(IntPtr owned) : base(owned, at => Functions.mien_evaluation_release(at)) { }

        /// <summary>The table as a JSON object: "expressions", a list, and "all" (without the neutral faces), each with faces,
        /// baseline, result, against (mean_mm, sd_mm, max_vertex_mm) and the effects cohens_d, superiority; with
        /// options.volume_zones "volumes", the same per zone (mean_ml, sd_ml, median_ml).</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_evaluation_get_json()</remarks>
        public string GetJson()
        {
            using (var call = new Call())
            {
                var evaluationAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_evaluation_get_json(evaluationAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }
    }
}
