// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>A finished search for a kernel's settings. Immutable.</summary>
    public sealed unsafe class Tuning : NativeObject
    {
        internal Tuning(IntPtr owned) : base(owned, at => Functions.mien_tuning_release(at)) { }

        /// <summary>Residuals as JSON text by the two-call protocol: best_sigma_mm, best_scale_mm, best_levels and, per combination,
        /// its sigma, scale and levels, and mean, deviation and every face's residual norm in mm.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_tuning_get_json()</remarks>
        public string GetJson()
        {
            using (var call = new Call())
            {
                var tuningAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_tuning_get_json(tuningAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }
    }
}
