// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Visits of one person: neutral faces and what changed between them. Immutable: share freely.</summary>
    public sealed unsafe class Study : NativeObject
    {
        internal Study(IntPtr owned) : base(owned, at => Functions.mien_study_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public Study Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_study_retain(at);
                return new Study(at);
            }
        }

        /// <summary>Studies the visits of one person: takes the expressions off all faces together, aligns each visit on the first
        /// by what holds still, and measures what changed per zone with its errors. One registration: its neutral face and
        /// how surely it is known.</summary>
        /// <param name="registrations">registration_count fits of one model, first visit first.</param>
        /// <param name="expressions">may be left out: faces are measured as they are held.</param>
        /// <param name="options">may be left out: defaults, with the zones of the registrations' model. Zones are patches, as those of
        /// mien_measure_volume().</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (topology, zones),
        /// MIEN_E_NOT_FOUND (a zone's name), MIEN_E_NO_SOLUTION, MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_MEMORY,
        /// MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_study_create()</remarks>
        public static Study Create(Session session, IReadOnlyList<Registration> registrations, ExpressionModel expressions = null, StudyOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Required(registrations, "registrations");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var registrationCount = call.Rows(registrations, 1, "registrations");
                var registrationsAt = call.Handles(registrations);
                var expressionsAt = call.UseOrNull(expressions);
                var optionsAt = (options ?? new StudyOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_study_create(sessionAt, registrationsAt, (uint)registrationCount, expressionsAt, optionsAt, outAt, call.Error));
                return call.Keep(new Study(call.Pointer(outAt)));
            }
        }

        /// <summary>Studies the visits of one person: takes the expressions off all faces together, aligns each visit on the first
        /// by what holds still, and measures what changed per zone with its errors. One registration: its neutral face and
        /// how surely it is known.</summary>
        /// <param name="registrations">registration_count fits of one model, first visit first.</param>
        /// <param name="expressions">may be left out: faces are measured as they are held.</param>
        /// <param name="options">may be left out: defaults, with the zones of the registrations' model. Zones are patches, as those of
        /// mien_measure_volume().</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (topology, zones),
        /// MIEN_E_NOT_FOUND (a zone's name), MIEN_E_NO_SOLUTION, MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_MEMORY,
        /// MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_study_create()</remarks>
        public static Task<Study> CreateAsync(Session session, IReadOnlyList<Registration> registrations, ExpressionModel expressions = null, StudyOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Create(session, registrations, expressions, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>The same from meshes that were fitted elsewhere. Without deviations nothing is said of errors: sd, low, high and
        /// limit_of_detection are NaN.</summary>
        /// <param name="faces">face_count meshes in one topology, mm, first visit first.</param>
        /// <param name="normalSd">may be left out; face_count x #V values, face by face, mm, &gt;= 0: how far each surface may lie off the skin
        /// along its normal.</param>
        /// <param name="weights">may be left out: all was seen, as far as is known; face_count x #V values, face by face, 0 to 1: 0 where a scan
        /// had no data.</param>
        /// <param name="expressions">may be left out: faces are measured as they are held.</param>
        /// <param name="options">may be left out: defaults, without any zone. noise_mm is not read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (topology, zones,
        /// deviations, weights), MIEN_E_NOT_FOUND (a zone's name), MIEN_E_NO_SOLUTION, MIEN_E_UNSUPPORTED_OPTION,
        /// MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_study_create_from_meshes()</remarks>
        public static Study CreateFromMeshes(Session session, IReadOnlyList<Mesh> faces, Values normalSd = null, Values weights = null, ExpressionModel expressions = null, StudyOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Required(faces, "faces");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var faceCount = call.Rows(faces, 1, "faces");
                var facesAt = call.Handles(faces);
                var normalSdAt = call.ViewOrNull(normalSd, 1, "normal_sd");
                var weightsAt = call.ViewOrNull(weights, 1, "weights");
                var expressionsAt = call.UseOrNull(expressions);
                var optionsAt = (options ?? new StudyOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_study_create_from_meshes(sessionAt, facesAt, (uint)faceCount, normalSdAt, weightsAt, expressionsAt, optionsAt, outAt, call.Error));
                return call.Keep(new Study(call.Pointer(outAt)));
            }
        }

        /// <summary>The same from meshes that were fitted elsewhere. Without deviations nothing is said of errors: sd, low, high and
        /// limit_of_detection are NaN.</summary>
        /// <param name="faces">face_count meshes in one topology, mm, first visit first.</param>
        /// <param name="normalSd">may be left out; face_count x #V values, face by face, mm, &gt;= 0: how far each surface may lie off the skin
        /// along its normal.</param>
        /// <param name="weights">may be left out: all was seen, as far as is known; face_count x #V values, face by face, 0 to 1: 0 where a scan
        /// had no data.</param>
        /// <param name="expressions">may be left out: faces are measured as they are held.</param>
        /// <param name="options">may be left out: defaults, without any zone. noise_mm is not read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (topology, zones,
        /// deviations, weights), MIEN_E_NOT_FOUND (a zone's name), MIEN_E_NO_SOLUTION, MIEN_E_UNSUPPORTED_OPTION,
        /// MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_study_create_from_meshes()</remarks>
        public static Task<Study> CreateFromMeshesAsync(Session session, IReadOnlyList<Mesh> faces, Values normalSd = null, Values weights = null, ExpressionModel expressions = null, StudyOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => CreateFromMeshes(session, faces, normalSd, weights, expressions, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>How many visits and zones a study has. The treated zones with their margin are the last zones.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_study_get_counts()</remarks>
        public StudyCounts GetCounts()
        {
            using (var call = new Call())
            {
                var studyAt = call.Use(this);
                var visitCountAt = call.Room(8);
                var zoneCountAt = call.Room(8);
                call.Check(Functions.mien_study_get_counts(studyAt, visitCountAt, zoneCountAt, call.Error));
                return new StudyCounts(*(uint*)visitCountAt, *(uint*)zoneCountAt);
            }
        }

        /// <summary>The name of a zone.</summary>
        /// <param name="zone">0 to zone_count - 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (zone)</exception>
        /// <remarks>C: mien_study_get_zone_name()</remarks>
        public string GetZoneName(int zone)
        {
            using (var call = new Call())
            {
                var studyAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_study_get_zone_name(studyAt, zone, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>The name of the expression that was taken off a visit.</summary>
        /// <param name="visit">0 to visit_count - 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (visit)</exception>
        /// <remarks>C: mien_study_get_expression()</remarks>
        public string GetExpression(int visit)
        {
            using (var call = new Call())
            {
                var studyAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_study_get_expression(studyAt, visit, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>The neutral face of a visit, in its own frame or aligned on another visit.</summary>
        /// <param name="visit">0 to visit_count - 1.</param>
        /// <param name="frame">the visit in whose frame to give it: its own number for its own frame.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (a visit), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_study_get_mesh()</remarks>
        public Mesh GetMesh(int visit, int frame)
        {
            using (var call = new Call())
            {
                var studyAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_study_get_mesh(studyAt, visit, frame, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Copies a field with one float64 per vertex of a visit's face.</summary>
        /// <param name="visit">0 to visit_count - 1.</param>
        /// <param name="field">MIEN_STUDY_FIELD_*.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (visit, or nothing is known of such a field)</exception>
        /// <remarks>C: mien_study_get_field()</remarks>
        public double[] GetField(int visit, StudyField field)
        {
            using (var call = new Call())
            {
                var studyAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_study_get_field(studyAt, visit, (int)field, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows);
            }
        }

        /// <summary>How far each vertex moved between two visits: the signed distance of the second neutral face, aligned, from the
        /// first along the first one's normals, mm.</summary>
        /// <param name="first">0 to visit_count - 1.</param>
        /// <param name="second">another visit.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (first is second), MIEN_E_NOT_FOUND (a visit),
        /// MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_study_get_distances()</remarks>
        public double[] GetDistances(int first, int second)
        {
            using (var call = new Call())
            {
                var studyAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_study_get_distances(studyAt, first, second, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows);
            }
        }

        /// <summary>How the second visit was aligned on the first.</summary>
        /// <param name="first">0 to visit_count - 1.</param>
        /// <param name="second">another visit.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (first is second), MIEN_E_NOT_FOUND (a visit),
        /// MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_study_get_alignment()</remarks>
        public ZoneAlignment GetAlignment(int first, int second)
        {
            using (var call = new Call())
            {
                var studyAt = call.Use(this);
                var outAt = call.Sized(sizeof(Native.ZoneAlignment));
                call.Check(Functions.mien_study_get_alignment(studyAt, first, second, outAt, call.Error));
                return ZoneAlignment.Read(call, outAt);
            }
        }

        /// <summary>What changed in a zone from one visit to another.</summary>
        /// <param name="first">0 to visit_count - 1.</param>
        /// <param name="second">another visit.</param>
        /// <param name="zone">0 to zone_count - 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (first is second), MIEN_E_NOT_FOUND (a visit or zone),
        /// MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_study_get_change()</remarks>
        public StudyChange GetChange(int first, int second, int zone)
        {
            using (var call = new Call())
            {
                var studyAt = call.Use(this);
                var outAt = call.Sized(sizeof(Native.StudyChange));
                call.Check(Functions.mien_study_get_change(studyAt, first, second, zone, outAt, call.Error));
                return StudyChange.Read(call, outAt);
            }
        }

        /// <summary>The study as a JSON object: "recipe" with every setting, "zones", and "visits" with the expression of each and
        /// "changes_since_first" per zone.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_study_get_json()</remarks>
        public string GetJson()
        {
            using (var call = new Call())
            {
                var studyAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_study_get_json(studyAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }
    }
}
