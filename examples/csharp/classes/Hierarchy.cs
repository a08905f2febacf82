// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Levels of a template with maps between them. Immutable: share freely.</summary>
    public sealed unsafe class Hierarchy : NativeObject
    {
        internal Hierarchy(IntPtr owned) : base(owned, at => Functions.mien_hierarchy_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public Hierarchy Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_hierarchy_retain(at);
                return new Hierarchy(at);
            }
        }

        /// <summary>Levels by quadric edge collapse, with barycentric maps up and selections down.</summary>
        /// <param name="mesh">an orientable manifold.</param>
        /// <param name="levelCount">levels below the mesh itself, 1 to 32; fewer when no collapse is legal.</param>
        /// <param name="factor">vertices are divided by this from level to level; above 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_hierarchy_build_quadric()</remarks>
        public static Hierarchy BuildQuadric(Session session, Mesh mesh, uint levelCount, double factor)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var meshAt = call.Use(mesh);
                var outAt = call.Room(8);
                call.Check(Functions.mien_hierarchy_build_quadric(sessionAt, meshAt, levelCount, factor, outAt, call.Error));
                return call.Keep(new Hierarchy(call.Pointer(outAt)));
            }
        }

        /// <summary>Levels sampled from the connectivity alone.</summary>
        /// <param name="levelCount">levels below the mesh itself, 1 to 32.</param>
        /// <param name="stride">least distance of kept vertices in edges, at least 1.</param>
        /// <param name="radius">edges over which the maps reach, stride - 1 to 64.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_hierarchy_build_connectivity()</remarks>
        public static Hierarchy BuildConnectivity(Session session, Mesh mesh, uint levelCount, uint stride, uint radius)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var meshAt = call.Use(mesh);
                var outAt = call.Room(8);
                call.Check(Functions.mien_hierarchy_build_connectivity(sessionAt, meshAt, levelCount, stride, radius, outAt, call.Error));
                return call.Keep(new Hierarchy(call.Pointer(outAt)));
            }
        }

        /// <summary>Opens a hierarchy file.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_WRONG_KIND,
        /// MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_hierarchy_load()</remarks>
        public static Hierarchy Load(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_hierarchy_load(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new Hierarchy(call.Pointer(outAt)));
            }
        }

        /// <summary>Writes a hierarchy file (safetensors; maps as compressed rows). Atomic.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_hierarchy_save()</remarks>
        public void Save(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var hierarchyAt = call.Use(this);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_hierarchy_save(sessionAt, hierarchyAt, pathAt, call.Error));
            }
        }

        /// <summary>Number of levels, the finest included.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_hierarchy_get_level_count()</remarks>
        public uint GetLevelCount()
        {
            using (var call = new Call())
            {
                var hierarchyAt = call.Use(this);
                var levelCountAt = call.Room(8);
                call.Check(Functions.mien_hierarchy_get_level_count(hierarchyAt, levelCountAt, call.Error));
                return *(uint*)levelCountAt;
            }
        }

        /// <summary>The mesh of a level; level 0 is the finest. Sampled levels of the connectivity kind have no triangles.</summary>
        /// <param name="level">0 to level_count - 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (level), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_hierarchy_get_level()</remarks>
        public Mesh GetLevel(uint level)
        {
            using (var call = new Call())
            {
                var hierarchyAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_hierarchy_get_level(hierarchyAt, level, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Applies a map to values on vertices: dst = map values.</summary>
        /// <param name="level">1 to level_count - 1: the coarser level of the map.</param>
        /// <param name="direction">MIEN_MAP_DOWN or MIEN_MAP_UP.</param>
        /// <param name="values">row_count x channel_count row-major float64.</param>
        /// <param name="channelCount">values a vertex, 1 to 4096.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (direction), MIEN_E_MISMATCH
        /// (row_count), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_hierarchy_apply()</remarks>
        public double[] Apply(uint level, MapKind direction, double[] values, ulong channelCount)
        {
            using (var call = new Call())
            {
                call.Required(values, "values");
                var hierarchyAt = call.Use(this);
                var rowCount = call.Rows(values, (long) channelCount, "values");
                var valuesAt = call.Array(values);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity((long) channelCount * 8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * (long) channelCount * 8);
                } while ((capacity = call.More(Functions.mien_hierarchy_apply(hierarchyAt, level, (int)direction, valuesAt, (ulong)rowCount, channelCount, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows * (long) channelCount);
            }
        }

        /// <summary>A map as a sparse matrix: its entries by rows, ascending, each row adding up to one. With all arrays null and
        /// capacity 0: the counts only.</summary>
        /// <param name="level">1 to level_count - 1: the coarser level of the map.</param>
        /// <param name="direction">MIEN_MAP_DOWN or MIEN_MAP_UP.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (direction)</exception>
        /// <remarks>C: mien_hierarchy_get_map()</remarks>
        public HierarchyMap GetMap(uint level, MapKind direction)
        {
            using (var call = new Call())
            {
                var hierarchyAt = call.Use(this);
                var rowCountAt = call.Room(8);
                var columnCountAt = call.Room(8);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr rowsAt;
                IntPtr columnsAt;
                IntPtr valuesAt;
                do {
                    rowsAt = call.Room(capacity * 4);
                    columnsAt = call.Room(capacity * 4);
                    valuesAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_hierarchy_get_map(hierarchyAt, level, (int)direction, rowsAt, columnsAt, valuesAt, (ulong)capacity, countAt, rowCountAt, columnCountAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return new HierarchyMap(call.ReadUints(rowsAt, rows), call.ReadUints(columnsAt, rows), call.ReadDoubles(valuesAt, rows), *(ulong*)rowCountAt, *(ulong*)columnCountAt);
            }
        }
    }
}
