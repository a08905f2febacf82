// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What was measured: numbers per zone and values per vertex. Immutable: share freely.</summary>
    public sealed unsafe class Measurement : NativeObject
    {
        internal Measurement(IntPtr owned) : base(owned, at => Functions.mien_measurement_release(at)) { }

        /// <summary>How many zones were measured.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_measurement_get_zones()</remarks>
        public MeasurementZones GetZones()
        {
            using (var call = new Call())
            {
                var measurementAt = call.Use(this);
                var zoneCountAt = call.Room(8);
                var zonesDisjointAt = call.Room(8);
                call.Check(Functions.mien_measurement_get_zones(measurementAt, zoneCountAt, zonesDisjointAt, call.Error));
                return new MeasurementZones(*(uint*)zoneCountAt, *(int*)zonesDisjointAt);
            }
        }

        /// <summary>The volume of a zone.</summary>
        /// <param name="zone">0 .. zone_count - 1, MIEN_ZONE_WHOLE or MIEN_ZONE_REST.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (no such zone, no volume in it)</exception>
        /// <remarks>C: mien_measurement_get_volume()</remarks>
        public ZoneVolume GetVolume(int zone)
        {
            using (var call = new Call())
            {
                var measurementAt = call.Use(this);
                var outAt = call.Sized(sizeof(Native.ZoneVolume));
                call.Check(Functions.mien_measurement_get_volume(measurementAt, zone, outAt, call.Error));
                return ZoneVolume.Read(call, outAt);
            }
        }

        /// <summary>The distances of a zone.</summary>
        /// <param name="zone">0 .. zone_count - 1 or MIEN_ZONE_WHOLE.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (no such zone, no distance in it)</exception>
        /// <remarks>C: mien_measurement_get_distance()</remarks>
        public ZoneDistance GetDistance(int zone)
        {
            using (var call = new Call())
            {
                var measurementAt = call.Use(this);
                var outAt = call.Sized(sizeof(Native.ZoneDistance));
                call.Check(Functions.mien_measurement_get_distance(measurementAt, zone, outAt, call.Error));
                return ZoneDistance.Read(call, outAt);
            }
        }

        /// <summary>Copies a field with one float64 per vertex of the before face; NaN where there was no partner.</summary>
        /// <param name="field">MIEN_FIELD_*.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (this measurement has no such field)</exception>
        /// <remarks>C: mien_measurement_get_field()</remarks>
        public double[] GetField(Field field)
        {
            using (var call = new Call())
            {
                var measurementAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_measurement_get_field(measurementAt, (int)field, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows);
            }
        }

        /// <summary>The whole measurement as JSON text.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_measurement_get_json()</remarks>
        public string GetJson()
        {
            using (var call = new Call())
            {
                var measurementAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_measurement_get_json(measurementAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>The mirror plane of a comparison of left and right.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (another measurement)</exception>
        /// <remarks>C: mien_measurement_get_mirror_plane()</remarks>
        public MirrorPlane GetMirrorPlane()
        {
            using (var call = new Call())
            {
                var measurementAt = call.Use(this);
                var outAt = call.Sized(sizeof(Native.MirrorPlane));
                call.Check(Functions.mien_measurement_get_mirror_plane(measurementAt, outAt, call.Error));
                return MirrorPlane.Read(call, outAt);
            }
        }
    }
}
