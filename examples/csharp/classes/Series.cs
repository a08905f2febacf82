// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Several scans of one person, neutralized together. Immutable: share freely between threads.</summary>
    public sealed unsafe class Series : NativeObject
    {
        internal Series(IntPtr owned) : base(owned, at => Functions.mien_series_release(at)) { }

        /// <summary>The neutral mesh of one face of a series, in that face's frame; or the person's shared one.</summary>
        /// <param name="index">0 to face_count - 1, or -1: the shared neutral face, in the training's frame.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (index), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_series_get_mesh()</remarks>
        public Mesh GetMesh(int index)
        {
            using (var call = new Call())
            {
                var seriesAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_series_get_mesh(seriesAt, index, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>The report as a JSON object: "faces", a list with each face's expression, residual_rms_mm (distance from its own
        /// fit), distance_to_shared_mm (root mean square distance of its neutral face from the shared one, without the
        /// changing vertices) and warnings.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_series_get_json()</remarks>
        public string GetJson()
        {
            using (var call = new Call())
            {
                var seriesAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_series_get_json(seriesAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }
    }
}
