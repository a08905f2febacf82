// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>One person's faces at several visits, without their expressions. Immutable: share freely between threads.</summary>
    public sealed unsafe class Visits : NativeObject
    {
        internal Visits(IntPtr owned) : base(owned, at => Functions.mien_visits_release(at)) { }

        /// <summary>The neutral face of one visit, in the frame of its face.</summary>
        /// <param name="index">0 to face_count - 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (index), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_visits_get_mesh()</remarks>
        public Mesh GetMesh(int index)
        {
            using (var call = new Call())
            {
                var visitsAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_visits_get_mesh(visitsAt, index, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>The name of the expression found at one visit.</summary>
        /// <param name="index">0 to face_count - 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (index)</exception>
        /// <remarks>C: mien_visits_get_expression()</remarks>
        public string GetExpression(int index)
        {
            using (var call = new Call())
            {
                var visitsAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_visits_get_expression(visitsAt, index, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>What the expressions that were taken off amount to in a volume between two visits, and how surely they are
        /// known. A neutral volume carries that doubt beside the doubts of the fits.</summary>
        /// <param name="first">0 to face_count - 1.</param>
        /// <param name="second">0 to face_count - 1.</param>
        /// <param name="zone">may be left out: the whole face.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (zone), MIEN_E_NOT_FOUND (a visit),
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_visits_get_removed_volume()</remarks>
        public VisitsRemovedVolume GetRemovedVolume(int first, int second, Zone zone = null)
        {
            using (var call = new Call())
            {
                var visitsAt = call.Use(this);
                var zoneAt = call.Record(zone, sizeof(Native.Zone), true, "zone");
                var removedMlAt = call.Room(8);
                var sdMlAt = call.Room(8);
                call.Check(Functions.mien_visits_get_removed_volume(visitsAt, first, second, zoneAt, removedMlAt, sdMlAt, call.Error));
                return new VisitsRemovedVolume(*(double*)removedMlAt, *(double*)sdMlAt);
            }
        }
    }
}
