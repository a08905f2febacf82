// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>A neutralized face. Immutable: share freely between threads.</summary>
    public sealed unsafe class Neutralization : NativeObject
    {
        internal Neutralization(IntPtr owned) : base(owned, at => Functions.mien_neutralization_release(at)) { }

        /// <summary>The neutral face with the triangles, colours and texture of the input, borrowed.</summary>
        /// <exception cref="MienException">none (null for a null or released handle)</exception>
        /// <remarks>C: mien_neutralization_mesh()</remarks>
        public Mesh GetMesh()
        {
            using (var call = new Call())
            {
                var neutralizationAt = call.Use(this);
                var lent = Functions.mien_neutralization_mesh(neutralizationAt);
                Functions.mien_mesh_retain(lent);
                return new Mesh(lent);
            }
        }

        /// <summary>Numbers of vertices of the neutral face and of coordinates of mien_neutralization_get_coordinates().</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_neutralization_get_counts()</remarks>
        public NeutralizationCounts GetCounts()
        {
            using (var call = new Call())
            {
                var neutralizationAt = call.Use(this);
                var vertexCountAt = call.Room(8);
                var identityModesAt = call.Room(8);
                var expressionModesAt = call.Room(8);
                call.Check(Functions.mien_neutralization_get_counts(neutralizationAt, vertexCountAt, identityModesAt, expressionModesAt, call.Error));
                return new NeutralizationCounts(*(ulong*)vertexCountAt, *(uint*)identityModesAt, *(uint*)expressionModesAt);
            }
        }

        /// <summary>Coordinates of the face in the model, mm along the unit modes. mien_neutralization_get_counts() says how many.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_neutralization_get_coordinates()</remarks>
        public NeutralizationCoordinates GetCoordinates()
        {
            using (var call = new Call())
            {
                var neutralizationAt = call.Use(this);
                var identityAt = call.Room((long)this.GetCounts().IdentityModes * 8);
                var expressionAt = call.Room((long)this.GetCounts().ExpressionModes * 8);
                call.Check(Functions.mien_neutralization_get_coordinates(neutralizationAt, identityAt, expressionAt, call.Error));
                return new NeutralizationCoordinates(call.ReadDoubles(identityAt, (long)this.GetCounts().IdentityModes), call.ReadDoubles(expressionAt, (long)this.GetCounts().ExpressionModes));
            }
        }

        /// <summary>Deviation per vertex of the neutral face that comes from not knowing the expression, mm.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (options.uncertainty was 0, or a fit without a prior)</exception>
        /// <remarks>C: mien_neutralization_get_uncertainty()</remarks>
        public double[] GetUncertainty()
        {
            using (var call = new Call())
            {
                var neutralizationAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_neutralization_get_uncertainty(neutralizationAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows);
            }
        }

        /// <summary>How a treated zone is read, both ways: treatments of lips, brows and the corners of the mouth can look like
        /// expressions.</summary>
        /// <param name="reading">MIEN_READING_*.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (reading), MIEN_E_NOT_FOUND (nothing
        /// was treated)</exception>
        /// <remarks>C: mien_neutralization_get_reading()</remarks>
        public ZoneReading GetReading(Reading reading)
        {
            using (var call = new Call())
            {
                var neutralizationAt = call.Use(this);
                var outAt = call.Sized(sizeof(Native.ZoneReading));
                call.Check(Functions.mien_neutralization_get_reading(neutralizationAt, (int)reading, outAt, call.Error));
                return ZoneReading.Read(call, outAt);
            }
        }

        /// <summary>The report as a JSON object: expression found, its probability and the others', displacement, residual,
        /// coordinates; with options.treated both readings of the zone.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_neutralization_get_json()</remarks>
        public string GetJson()
        {
            using (var call = new Call())
            {
                var neutralizationAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_neutralization_get_json(neutralizationAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>Carries the neutralizing displacement onto the scan's own vertices; triangles, colours and texture of the scan
        /// stay. Parts far from the template move rigidly with their neighbourhood.</summary>
        /// <param name="scan">in the frame of the face.</param>
        /// <param name="maxDistanceMm">how far from the fitted face a vertex takes its displacement; 0: 6 mm.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_neutralization_apply_to_scan()</remarks>
        public Mesh ApplyToScan(Session session, Mesh scan, double maxDistanceMm)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var neutralizationAt = call.Use(this);
                var scanAt = call.Use(scan);
                var outAt = call.Room(8);
                call.Check(Functions.mien_neutralization_apply_to_scan(sessionAt, neutralizationAt, scanAt, maxDistanceMm, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }
    }
}
