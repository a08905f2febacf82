// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>A list of named sets of vertices. Immutable: share freely.</summary>
    public sealed unsafe class Zones : NativeObject
    {
        internal Zones(IntPtr owned) : base(owned, at => Functions.mien_zones_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public Zones Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_zones_retain(at);
                return new Zones(at);
            }
        }

        /// <summary>Reads a zone file {"zones": {name: [vertex, ...]}}; further lists of vertices beside "zones", such as "lips",
        /// are zones too.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_MEMORY_BUDGET,
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_zones_load()</remarks>
        public static Zones Load(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_zones_load(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new Zones(call.Pointer(outAt)));
            }
        }

        /// <summary>Makes a list of zones from the host's.</summary>
        /// <param name="zones">zone_count of them, each of at most 16777216 vertices; null allowed when that is 0. Names must differ.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_zones_create()</remarks>
        public static Zones Create(IReadOnlyList<Zone> zones = null)
        {
            using (var call = new Call())
            {
                var zoneCount = call.Rows(zones, 1, "zones");
                var zonesAt = call.Records(zones, sizeof(Native.Zone));
                var outAt = call.Room(8);
                call.Check(Functions.mien_zones_create(zonesAt, (ulong)zoneCount, outAt, call.Error));
                return call.Keep(new Zones(call.Pointer(outAt)));
            }
        }

        /// <summary>Writes a zone file. Atomic.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_MEMORY_BUDGET,
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_zones_save()</remarks>
        public void Save(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var zonesAt = call.Use(this);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_zones_save(sessionAt, zonesAt, pathAt, call.Error));
            }
        }

        /// <summary>How many zones there are.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_zones_get_count()</remarks>
        public ulong GetCount()
        {
            using (var call = new Call())
            {
                var zonesAt = call.Use(this);
                var countAt = call.Room(8);
                call.Check(Functions.mien_zones_get_count(zonesAt, countAt, call.Error));
                return *(ulong*)countAt;
            }
        }

        /// <summary>The name of one zone.</summary>
        /// <param name="index">below the count.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index)</exception>
        /// <remarks>C: mien_zones_get_name()</remarks>
        public string GetName(ulong index)
        {
            using (var call = new Call())
            {
                var zonesAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_zones_get_name(zonesAt, index, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>The vertices of one zone. With dst null and capacity 0: their number only.</summary>
        /// <param name="index">below the count.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index)</exception>
        /// <remarks>C: mien_zones_get_vertices()</remarks>
        public uint[] GetVertices(ulong index)
        {
            using (var call = new Call())
            {
                var zonesAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(4);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 4);
                } while ((capacity = call.More(Functions.mien_zones_get_vertices(zonesAt, index, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadUints(dstAt, rows);
            }
        }
    }
}
