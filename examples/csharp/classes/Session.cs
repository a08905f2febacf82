// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Threads, limits of memory and time, and logging. Externally synchronized: one call at a time; with more than one
    /// thread of its own, a session that is in a call on another thread refuses a second call with MIEN_E_BUSY. A
    /// callback may call the library with the session that called it. Objects made in a session may outlive it.</summary>
    public sealed unsafe class Session : NativeObject
    {
        internal Session(IntPtr owned) : base(owned, at => Functions.mien_session_release(at)) { }

        /// <summary>Makes a session with default options: one thread, no memory budget, silent.</summary>
        public Session() : base(Create()) { }

        /// <summary>Makes a session with options of the caller.</summary>
        public Session(SessionOptions options) : base(CreateWithOptions(options)) { }

        /// <summary>Makes a session with default options: one thread, no memory budget, silent.</summary>
        /// <exception cref="MienException">MIEN_E_UNSUPPORTED_VERSION (another ABI), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_session_create()</remarks>
        public static Session Create()
        {
            using (var call = new Call())
            {
                var outAt = call.Room(8);
                call.Check(Functions.mien_session_create(Functions.AbiVersion, outAt, call.Error));
                return call.Keep(new Session(call.Pointer(outAt)));
            }
        }

        /// <summary>Makes a session with options of the caller.</summary>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_ARGUMENT (num_threads), MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_MEMORY
        /// (also when a thread cannot be started)</exception>
        /// <remarks>C: mien_session_create_with_options()</remarks>
        public static Session CreateWithOptions(SessionOptions options = null)
        {
            using (var call = new Call())
            {
                var optionsAt = call.Record(options, sizeof(Native.SessionOptions), true, "options");
                var outAt = call.Room(8);
                call.Check(Functions.mien_session_create_with_options(Functions.AbiVersion, optionsAt, outAt, call.Error));
                return call.Keep(new Session(call.Pointer(outAt)));
            }
        }

        /// <summary>The SHA-256 of a file's bytes as 64 lower-case hexadecimal digits: which model, which scan a result was made
        /// from. With dst null and capacity 0: the size only, without reading the file.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY, MIEN_E_TIME_LIMIT</exception>
        /// <remarks>C: mien_session_hash_file()</remarks>
        public string HashFile(string path)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var pathAt = call.Text(path);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_session_hash_file(sessionAt, pathAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>Lengths, lengths along the skin, angles, inclinations and proportions between the landmarks of a face: some
        /// hundred of the field's, always in the same order. Landmarks go by the field's names ("pronasale",
        /// "cheilion_left") or abbreviations ("prn", "ch_left"), or by those of the 68-point scheme that truly coincide
        /// with one of the field (jaw_08 is gnathion; nose_base_0 is no alare). A measurement whose landmarks are missing
        /// is NaN with a reason.</summary>
        /// <param name="face">#V x 3, mm, with triangles.</param>
        /// <param name="landmarks">vertices of the face, or places on it in its frame (a measurement with a place has no deviation, and no length
        /// along the skin).</param>
        /// <param name="options">may be left out: no deviations, no norms.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (landmarks, deviations),
        /// MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_anthropometry()</remarks>
        public Anthropometry MeasureAnthropometry(Mesh face, Landmarks landmarks, AnthropometryOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var faceAt = call.Use(face);
                var landmarksAt = call.Use(landmarks);
                var optionsAt = (options ?? new AnthropometryOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_measure_anthropometry(sessionAt, faceAt, landmarksAt, optionsAt, outAt, call.Error));
                return call.Keep(new Anthropometry(call.Pointer(outAt)));
            }
        }

        /// <summary>Lengths, lengths along the skin, angles, inclinations and proportions between the landmarks of a face: some
        /// hundred of the field's, always in the same order. Landmarks go by the field's names ("pronasale",
        /// "cheilion_left") or abbreviations ("prn", "ch_left"), or by those of the 68-point scheme that truly coincide
        /// with one of the field (jaw_08 is gnathion; nose_base_0 is no alare). A measurement whose landmarks are missing
        /// is NaN with a reason.</summary>
        /// <param name="face">#V x 3, mm, with triangles.</param>
        /// <param name="landmarks">vertices of the face, or places on it in its frame (a measurement with a place has no deviation, and no length
        /// along the skin).</param>
        /// <param name="options">may be left out: no deviations, no norms.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (landmarks, deviations),
        /// MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_anthropometry()</remarks>
        public Task<Anthropometry> MeasureAnthropometryAsync(Mesh face, Landmarks landmarks, AnthropometryOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => MeasureAnthropometry(face, landmarks, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>The volume between two faces in correspondence: signed, positive, negative and absolute, whole and per zone,
        /// exact where the faces cross inside a triangle pair. A zone's edge runs linearly through the ring of triangles it
        /// shares; disjoint zones and the rest add up to the whole. A zone of twenty vertices or more of which most lie in
        /// no triangle of it is one of another template: MIEN_E_MISMATCH.</summary>
        /// <param name="before">#V x 3, mm, with triangles counter-clockwise seen from outside.</param>
        /// <param name="after">same vertex count, in the frame of before; its triangles are not read.</param>
        /// <param name="options">may be left out: the whole face, no uncertainty.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (no triangles), MIEN_E_MISMATCH (vertex
        /// counts, zones, deviations), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_volume()</remarks>
        public Measurement MeasureVolume(Mesh before, Mesh after, MeasureOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var beforeAt = call.Use(before);
                var afterAt = call.Use(after);
                var optionsAt = (options ?? new MeasureOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_measure_volume(sessionAt, beforeAt, afterAt, optionsAt, outAt, call.Error));
                return call.Keep(new Measurement(call.Pointer(outAt)));
            }
        }

        /// <summary>The volume between two faces in correspondence: signed, positive, negative and absolute, whole and per zone,
        /// exact where the faces cross inside a triangle pair. A zone's edge runs linearly through the ring of triangles it
        /// shares; disjoint zones and the rest add up to the whole. A zone of twenty vertices or more of which most lie in
        /// no triangle of it is one of another template: MIEN_E_MISMATCH.</summary>
        /// <param name="before">#V x 3, mm, with triangles counter-clockwise seen from outside.</param>
        /// <param name="after">same vertex count, in the frame of before; its triangles are not read.</param>
        /// <param name="options">may be left out: the whole face, no uncertainty.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (no triangles), MIEN_E_MISMATCH (vertex
        /// counts, zones, deviations), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_volume()</remarks>
        public Task<Measurement> MeasureVolumeAsync(Mesh before, Mesh after, MeasureOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => MeasureVolume(before, after, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Distances between two faces in correspondence, per vertex and per zone.</summary>
        /// <param name="before">#V x 3, mm.</param>
        /// <param name="after">same vertex count, in the frame of before.</param>
        /// <param name="options">may be left out; zones, progress and cancel are read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH, MIEN_E_NO_MEMORY,
        /// MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_distance()</remarks>
        public Measurement MeasureDistance(Mesh before, Mesh after, MeasureOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var beforeAt = call.Use(before);
                var afterAt = call.Use(after);
                var optionsAt = (options ?? new MeasureOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_measure_distance(sessionAt, beforeAt, afterAt, optionsAt, outAt, call.Error));
                return call.Keep(new Measurement(call.Pointer(outAt)));
            }
        }

        /// <summary>Distances between two faces in correspondence, per vertex and per zone.</summary>
        /// <param name="before">#V x 3, mm.</param>
        /// <param name="after">same vertex count, in the frame of before.</param>
        /// <param name="options">may be left out; zones, progress and cancel are read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH, MIEN_E_NO_MEMORY,
        /// MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_distance()</remarks>
        public Task<Measurement> MeasureDistanceAsync(Mesh before, Mesh after, MeasureOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => MeasureDistance(before, after, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Distances from the vertices of one surface to the closest place on another, in any topology; the Hausdorff
        /// distance takes both directions.</summary>
        /// <param name="before">#V x 3, mm, with triangles.</param>
        /// <param name="after">a surface or a cloud of points, aligned with before.</param>
        /// <param name="options">may be left out; zones (of before), max_distance_mm, skip_borders, progress, cancel.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH, MIEN_E_NO_MEMORY,
        /// MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_surface_distance()</remarks>
        public Measurement MeasureSurfaceDistance(Mesh before, Mesh after, MeasureOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var beforeAt = call.Use(before);
                var afterAt = call.Use(after);
                var optionsAt = (options ?? new MeasureOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_measure_surface_distance(sessionAt, beforeAt, afterAt, optionsAt, outAt, call.Error));
                return call.Keep(new Measurement(call.Pointer(outAt)));
            }
        }

        /// <summary>Distances from the vertices of one surface to the closest place on another, in any topology; the Hausdorff
        /// distance takes both directions.</summary>
        /// <param name="before">#V x 3, mm, with triangles.</param>
        /// <param name="after">a surface or a cloud of points, aligned with before.</param>
        /// <param name="options">may be left out; zones (of before), max_distance_mm, skip_borders, progress, cancel.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH, MIEN_E_NO_MEMORY,
        /// MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_surface_distance()</remarks>
        public Task<Measurement> MeasureSurfaceDistanceAsync(Mesh before, Mesh after, MeasureOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => MeasureSurfaceDistance(before, after, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>The volume that a mesh encloses, by the divergence theorem about its centroid.</summary>
        /// <param name="mesh">manifold along its edges and consistently oriented.</param>
        /// <param name="closeRims">1: each open rim is closed by a fan from the mean of its vertices; 0: an open mesh is an error.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (close_rims), MIEN_E_INVALID_MESH
        /// (open, not manifold or not oriented: the message counts the edges), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_measure_closed_volume()</remarks>
        public double MeasureClosedVolume(Mesh mesh, int closeRims)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var meshAt = call.Use(mesh);
                var volumeMlAt = call.Room(8);
                call.Check(Functions.mien_measure_closed_volume(sessionAt, meshAt, closeRims, volumeMlAt, call.Error));
                return *(double*)volumeMlAt;
            }
        }

        /// <summary>The area of a surface, or of a zone of it (a triangle's area is shared by its three vertices). Zones are
        /// patches, as those of mien_measure_volume().</summary>
        /// <param name="mesh">with triangles.</param>
        /// <param name="zone">may be left out: the whole surface.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (zone), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_measure_area()</remarks>
        public double MeasureArea(Mesh mesh, Zone zone = null)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var meshAt = call.Use(mesh);
                var zoneAt = call.Record(zone, sizeof(Native.Zone), true, "zone");
                var areaMm2At = call.Room(8);
                call.Check(Functions.mien_measure_area(sessionAt, meshAt, zoneAt, areaMm2At, call.Error));
                return *(double*)areaMm2At;
            }
        }

        /// <summary>Curvatures of a surface, per vertex and per zone, by fits of a cubic around each vertex.</summary>
        /// <param name="mesh">#V x 3, mm, with triangles counter-clockwise seen from outside.</param>
        /// <param name="radiusMm">&gt; 0; of the fits: what is smaller is smoothed away. 6 suits fitted faces.</param>
        /// <param name="robust">1: a second fit leaves spikes and lashes out; 0: none.</param>
        /// <param name="options">may be left out; zones, progress and cancel are read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (robust), MIEN_E_INVALID_MESH,
        /// MIEN_E_MISMATCH (zones), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_curvature()</remarks>
        public Measurement MeasureCurvature(Mesh mesh, double radiusMm, int robust, MeasureOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var meshAt = call.Use(mesh);
                var optionsAt = (options ?? new MeasureOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_measure_curvature(sessionAt, meshAt, radiusMm, robust, optionsAt, outAt, call.Error));
                return call.Keep(new Measurement(call.Pointer(outAt)));
            }
        }

        /// <summary>Curvatures of a surface, per vertex and per zone, by fits of a cubic around each vertex.</summary>
        /// <param name="mesh">#V x 3, mm, with triangles counter-clockwise seen from outside.</param>
        /// <param name="radiusMm">&gt; 0; of the fits: what is smaller is smoothed away. 6 suits fitted faces.</param>
        /// <param name="robust">1: a second fit leaves spikes and lashes out; 0: none.</param>
        /// <param name="options">may be left out; zones, progress and cancel are read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (robust), MIEN_E_INVALID_MESH,
        /// MIEN_E_MISMATCH (zones), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_curvature()</remarks>
        public Task<Measurement> MeasureCurvatureAsync(Mesh mesh, double radiusMm, int robust, MeasureOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => MeasureCurvature(mesh, radiusMm, robust, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Straight lengths and lengths along the surface between pairs of vertices.</summary>
        /// <param name="mesh">#V x 3, mm, with triangles.</param>
        /// <param name="pairs">pair_count x 2 vertex numbers.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (vertex),
        /// MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_measure_lengths()</remarks>
        public MeasureLengths MeasureLengths(Mesh mesh, uint[] pairs)
        {
            using (var call = new Call())
            {
                call.Required(pairs, "pairs");
                call.Lock(this);
                var sessionAt = call.Use(this);
                var meshAt = call.Use(mesh);
                var pairCount = call.Rows(pairs, 2, "pairs");
                var pairsAt = call.Array(pairs);
                var straightMmAt = call.Room(pairCount * 8);
                var geodesicMmAt = call.Room(pairCount * 8);
                call.Check(Functions.mien_measure_lengths(sessionAt, meshAt, pairsAt, (ulong)pairCount, straightMmAt, geodesicMmAt, call.Error));
                return new MeasureLengths(call.ReadDoubles(straightMmAt, pairCount), call.ReadDoubles(geodesicMmAt, pairCount));
            }
        }

        /// <summary>The volume between two surfaces that are not in correspondence, scan to scan: each vertex of before is carried
        /// onto after, then the swept volume is measured. Triangles without a partner do not count.</summary>
        /// <param name="before">#V x 3, mm, with triangles.</param>
        /// <param name="after">another surface with triangles, aligned with before.</param>
        /// <param name="carry">MIEN_CARRY_*.</param>
        /// <param name="direction">3 numbers, any length but zero; may be left out unless carry is MIEN_CARRY_DIRECTION.</param>
        /// <param name="options">may be left out; zones (of before), max_distance_mm (0: 20), limit_of_detection_ml, progress, cancel. Deviations
        /// are not read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH, MIEN_E_NO_SOLUTION
        /// (nothing within reach), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_scan_volume()</remarks>
        public MeasureScanVolume MeasureScanVolume(Mesh before, Mesh after, Carry carry, double[] direction = null, MeasureOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var beforeAt = call.Use(before);
                var afterAt = call.Use(after);
                call.Agree("direction", call.Rows(direction, 1, "direction"), 3);
                var directionAt = call.Array(direction);
                var optionsAt = (options ?? new MeasureOptions()).Write(call, progress, cancellationToken);
                var coverageAt = call.Room(8);
                var outAt = call.Room(8);
                call.Check(Functions.mien_measure_scan_volume(sessionAt, beforeAt, afterAt, (int)carry, directionAt, optionsAt, coverageAt, outAt, call.Error));
                return new MeasureScanVolume(*(double*)coverageAt, call.Keep(new Measurement(call.Pointer(outAt))));
            }
        }

        /// <summary>The volume between two surfaces that are not in correspondence, scan to scan: each vertex of before is carried
        /// onto after, then the swept volume is measured. Triangles without a partner do not count.</summary>
        /// <param name="before">#V x 3, mm, with triangles.</param>
        /// <param name="after">another surface with triangles, aligned with before.</param>
        /// <param name="carry">MIEN_CARRY_*.</param>
        /// <param name="direction">3 numbers, any length but zero; may be left out unless carry is MIEN_CARRY_DIRECTION.</param>
        /// <param name="options">may be left out; zones (of before), max_distance_mm (0: 20), limit_of_detection_ml, progress, cancel. Deviations
        /// are not read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH, MIEN_E_NO_SOLUTION
        /// (nothing within reach), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_scan_volume()</remarks>
        public Task<MeasureScanVolume> MeasureScanVolumeAsync(Mesh before, Mesh after, Carry carry, double[] direction = null, MeasureOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => MeasureScanVolume(before, after, carry, direction, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Moves one face rigidly onto another by a zone that has not changed (forehead, nose bridge), robustly: by
        /// correspondence first, then by closest points, because a fit slides along a scan more than it lifts off. Surfaces
        /// with other triangles (two scans) are brought together by closest points alone and must lie within 15 mm of each
        /// other there. The deviations feed alignment_rotation_sd_rad, alignment_translation_sd_mm and alignment_centre.</summary>
        /// <param name="moving">#V x 3, mm, with triangles.</param>
        /// <param name="target">with triangles.</param>
        /// <param name="stable">may be left out: all vertices. Vertices of target.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH, MIEN_E_NO_SOLUTION (zone
        /// too small or straight), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_measure_align()</remarks>
        public MeasureAlign MeasureAlign(Mesh moving, Mesh target, Zone stable = null)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var movingAt = call.Use(moving);
                var targetAt = call.Use(target);
                var stableAt = call.Record(stable, sizeof(Native.Zone), true, "stable");
                var infoAt = call.Sized(sizeof(Native.ZoneAlignment));
                var outAt = call.Room(8);
                call.Check(Functions.mien_measure_align(sessionAt, movingAt, targetAt, stableAt, infoAt, outAt, call.Error));
                return new MeasureAlign(ZoneAlignment.Read(call, infoAt), call.Keep(new Mesh(call.Pointer(outAt))));
            }
        }

        /// <summary>Compares the left side of a face with the reflection of its right side: volume and distance, signed (positive:
        /// the left side lies farther out), whole and per zone, with intervals. Zones of both sides ("cheek_left",
        /// "cheek_right") are one comparison ("cheek"); of a zone in the middle the left half is compared with the right
        /// half. The result holds volumes, distances, and fields of all vertices (a right vertex against the reflected left
        /// side).</summary>
        /// <param name="face">#V x 3, mm, in the template's topology.</param>
        /// <param name="templateMesh">the template, symmetric about its plane x = 0, +x to the left (mien_model_mesh()).</param>
        /// <param name="options">may be left out: the whole side, no interval.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (plane), MIEN_E_INVALID_MESH (no
        /// triangles; the template is not symmetric), MIEN_E_MISMATCH (vertex counts, zones, landmarks, deviations),
        /// MIEN_E_NO_SOLUTION (no plane is determined), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_asymmetry()</remarks>
        public Measurement MeasureAsymmetry(Mesh face, Mesh templateMesh, AsymmetryOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var faceAt = call.Use(face);
                var templateMeshAt = call.Use(templateMesh);
                var optionsAt = (options ?? new AsymmetryOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_measure_asymmetry(sessionAt, faceAt, templateMeshAt, optionsAt, outAt, call.Error));
                return call.Keep(new Measurement(call.Pointer(outAt)));
            }
        }

        /// <summary>Compares the left side of a face with the reflection of its right side: volume and distance, signed (positive:
        /// the left side lies farther out), whole and per zone, with intervals. Zones of both sides ("cheek_left",
        /// "cheek_right") are one comparison ("cheek"); of a zone in the middle the left half is compared with the right
        /// half. The result holds volumes, distances, and fields of all vertices (a right vertex against the reflected left
        /// side).</summary>
        /// <param name="face">#V x 3, mm, in the template's topology.</param>
        /// <param name="templateMesh">the template, symmetric about its plane x = 0, +x to the left (mien_model_mesh()).</param>
        /// <param name="options">may be left out: the whole side, no interval.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (plane), MIEN_E_INVALID_MESH (no
        /// triangles; the template is not symmetric), MIEN_E_MISMATCH (vertex counts, zones, landmarks, deviations),
        /// MIEN_E_NO_SOLUTION (no plane is determined), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_asymmetry()</remarks>
        public Task<Measurement> MeasureAsymmetryAsync(Mesh face, Mesh templateMesh, AsymmetryOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => MeasureAsymmetry(face, templateMesh, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Fits a model's template to a scan: start, then rounds of closest points, robust weights and a weighted solve
        /// with the model's prior, at falling noise levels; then a smooth field for the rest of the gap. A fit that cannot
        /// be trusted is not an error: ask mien_registration_get_verdict().</summary>
        /// <param name="scan">a surface or a cloud of points, any connectivity, any frame; its unit is detected (options.units), any rotation
        /// is found.</param>
        /// <param name="options">may be left out: no landmarks, all defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (nothing left after cleaning),
        /// MIEN_E_MISMATCH (scan_weights; landmarks whose left and right are exchanged), MIEN_E_NOT_FOUND (start by
        /// landmarks, fewer than three known to the model), MIEN_E_NO_SOLUTION, MIEN_E_UNSUPPORTED_OPTION,
        /// MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED, MIEN_E_CALLBACK</exception>
        /// <remarks>C: mien_register()</remarks>
        public Registration Register(Model model, Mesh scan, RegisterOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var modelAt = call.Use(model);
                var scanAt = call.Use(scan);
                var optionsAt = (options ?? new RegisterOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_register(sessionAt, modelAt, scanAt, optionsAt, outAt, call.Error));
                return call.Keep(new Registration(call.Pointer(outAt)));
            }
        }

        /// <summary>Fits a model's template to a scan: start, then rounds of closest points, robust weights and a weighted solve
        /// with the model's prior, at falling noise levels; then a smooth field for the rest of the gap. A fit that cannot
        /// be trusted is not an error: ask mien_registration_get_verdict().</summary>
        /// <param name="scan">a surface or a cloud of points, any connectivity, any frame; its unit is detected (options.units), any rotation
        /// is found.</param>
        /// <param name="options">may be left out: no landmarks, all defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (nothing left after cleaning),
        /// MIEN_E_MISMATCH (scan_weights; landmarks whose left and right are exchanged), MIEN_E_NOT_FOUND (start by
        /// landmarks, fewer than three known to the model), MIEN_E_NO_SOLUTION, MIEN_E_UNSUPPORTED_OPTION,
        /// MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED, MIEN_E_CALLBACK</exception>
        /// <remarks>C: mien_register()</remarks>
        public Task<Registration> RegisterAsync(Model model, Mesh scan, RegisterOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Register(model, scan, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Carries places (landmarks, points of a contour) from one surface to another in the same frame, e.g. from a
        /// fitted template to the scan under it or back: for each the nearest place on the other surface.</summary>
        /// <param name="surface">where the places go; a mesh or a cloud of points, mm.</param>
        /// <param name="points">#P x 3, F32 or F64, mm.</param>
        /// <param name="maxDistanceMm">farther places are lost (triangle 0xFFFFFFFF); 0: 10, below 0: no limit.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_surface_transfer_points()</remarks>
        public SurfaceTransferPoints SurfaceTransferPoints(Mesh surface, Values points, double maxDistanceMm)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var surfaceAt = call.Use(surface);
                var pointsAt = call.View(points, 3, "points");
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(3 * 8);
                IntPtr trianglesAt;
                IntPtr barycentricAt;
                IntPtr positionsAt;
                do {
                    trianglesAt = call.Room(capacity * 4);
                    barycentricAt = call.Room(capacity * 3 * 8);
                    positionsAt = call.Room(capacity * 3 * 8);
                } while ((capacity = call.More(Functions.mien_surface_transfer_points(sessionAt, surfaceAt, pointsAt, maxDistanceMm, trianglesAt, barycentricAt, positionsAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return new SurfaceTransferPoints(call.ReadUints(trianglesAt, rows), call.ReadDoubles(barycentricAt, rows * 3), call.ReadDoubles(positionsAt, rows * 3));
            }
        }

        /// <summary>Carries a zone from one surface to another in the same frame: the vertices of `to` whose nearest place on `from`
        /// lies in the zone (barycentric share of its vertices at least one half), ascending.</summary>
        /// <param name="from">with the zone's vertices.</param>
        /// <param name="maxDistanceMm">farther vertices stay out; 0: 10, below 0: no limit.</param>
        /// <param name="vertices">vertex_count vertex numbers of `from`</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (a fitted template without triangles),
        /// MIEN_E_MISMATCH (a vertex that `from` does not have), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_surface_transfer_zone()</remarks>
        public uint[] SurfaceTransferZone(Mesh from, Mesh to, double maxDistanceMm, uint[] vertices = null)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var fromAt = call.Use(from);
                var vertexCount = call.Rows(vertices, 1, "vertices");
                var verticesAt = call.Array(vertices);
                var toAt = call.Use(to);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(4);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 4);
                } while ((capacity = call.More(Functions.mien_surface_transfer_zone(sessionAt, fromAt, verticesAt, (ulong)vertexCount, toAt, maxDistanceMm, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadUints(dstAt, rows);
            }
        }

        /// <summary>A model's landmarks or zones, carried from its fitted template to a scan, as JSON text in the form of the
        /// landmark and zone files: {"points": {name: [x, y, z]}, "distances_mm": {name: d}} or {"zones": {name: [scan
        /// vertex, ...]}}.</summary>
        /// <param name="model">whose landmarks and zones are meant.</param>
        /// <param name="fitted">the model's template after registration.</param>
        /// <param name="scan">in the frame of fitted, mm.</param>
        /// <param name="what">MIEN_TRANSFER_LANDMARKS or MIEN_TRANSFER_ZONES.</param>
        /// <param name="maxDistanceMm">farther places are left out; 0: 10, below 0: no limit.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (what), MIEN_E_MISMATCH (fitted is not
        /// of the model), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_surface_transfer_json()</remarks>
        public string SurfaceTransferJson(Model model, Mesh fitted, Mesh scan, Transfer what, double maxDistanceMm)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var modelAt = call.Use(model);
                var fittedAt = call.Use(fitted);
                var scanAt = call.Use(scan);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_surface_transfer_json(sessionAt, modelAt, fittedAt, scanAt, (int)what, maxDistanceMm, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>Splits a face at mode k: the mean moved by its low, and by its high frequencies. low + high - mean is the face.</summary>
        /// <param name="face">#V vertices, mm, aligned with the mean shape.</param>
        /// <param name="k">0 to the basis' modes.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (k), MIEN_E_MISMATCH (vertex count), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_spectral_split()</remarks>
        public SpectralSplit SpectralSplit(SpectralBasis basis, Mesh face, ulong k)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var basisAt = call.Use(basis);
                var faceAt = call.Use(face);
                var lowAt = call.Room(8);
                var highAt = call.Room(8);
                call.Check(Functions.mien_spectral_split(sessionAt, basisAt, faceAt, k, lowAt, highAt, call.Error));
                return new SpectralSplit(call.Keep(new Mesh(call.Pointer(lowAt))), call.Keep(new Mesh(call.Pointer(highAt))));
            }
        }

        /// <summary>The low frequencies of one face with the high frequencies of another.</summary>
        /// <param name="low">#V vertices, mm.</param>
        /// <param name="high">#V vertices, mm.</param>
        /// <param name="k">0 to the basis' modes; #V or more gives `low`.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (k), MIEN_E_MISMATCH (vertex count), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_spectral_assemble()</remarks>
        public Mesh SpectralAssemble(SpectralBasis basis, Mesh low, Mesh high, ulong k)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var basisAt = call.Use(basis);
                var lowAt = call.Use(low);
                var highAt = call.Use(high);
                var outAt = call.Room(8);
                call.Check(Functions.mien_spectral_assemble(sessionAt, basisAt, lowAt, highAt, k, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Multiplies each band of a face by a gain: 0 smooths it away, 1 keeps it, more exaggerates it.</summary>
        /// <param name="face">#V vertices, mm.</param>
        /// <param name="gains">limit_count + 1 finite values.</param>
        /// <param name="limits">limit_count ascending mode numbers</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (limits, gains), MIEN_E_MISMATCH (vertex count), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_spectral_edit()</remarks>
        public Mesh SpectralEdit(SpectralBasis basis, Mesh face, double[] gains, ulong[] limits = null)
        {
            using (var call = new Call())
            {
                call.Required(gains, "gains");
                call.Lock(this);
                var sessionAt = call.Use(this);
                var basisAt = call.Use(basis);
                var faceAt = call.Use(face);
                var limitCount = call.Rows(limits, 1, "limits");
                var limitsAt = call.Array(limits);
                call.Agree("gains", call.Rows(gains, 1, "gains"), limitCount + 1);
                var gainsAt = call.Array(gains);
                var outAt = call.Room(8);
                call.Check(Functions.mien_spectral_edit(sessionAt, basisAt, faceAt, limitsAt, (ulong)limitCount, gainsAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Moves each band of one face towards another's by its own weight; weights 1 and 0 exchange details.</summary>
        /// <param name="first">#V vertices, mm; weight 0.</param>
        /// <param name="second">#V vertices, mm; weight 1.</param>
        /// <param name="weights">limit_count + 1 finite values.</param>
        /// <param name="limits">limit_count ascending mode numbers</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (limits, weights), MIEN_E_MISMATCH (vertex count),
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_spectral_mix()</remarks>
        public Mesh SpectralMix(SpectralBasis basis, Mesh first, Mesh second, double[] weights, ulong[] limits = null)
        {
            using (var call = new Call())
            {
                call.Required(weights, "weights");
                call.Lock(this);
                var sessionAt = call.Use(this);
                var basisAt = call.Use(basis);
                var firstAt = call.Use(first);
                var secondAt = call.Use(second);
                var limitCount = call.Rows(limits, 1, "limits");
                var limitsAt = call.Array(limits);
                call.Agree("weights", call.Rows(weights, 1, "weights"), limitCount + 1);
                var weightsAt = call.Array(weights);
                var outAt = call.Room(8);
                call.Check(Functions.mien_spectral_mix(sessionAt, basisAt, firstAt, secondAt, limitsAt, (ulong)limitCount, weightsAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Spectral coefficients of a face: U' M (face - mean), one row of x, y, z per mode, float64.</summary>
        /// <param name="face">#V vertices, mm, aligned with the mean shape.</param>
        /// <param name="modeCount">0 to the basis' modes: the first of them; more means all.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (vertex count), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_spectral_project()</remarks>
        public double[] SpectralProject(SpectralBasis basis, Mesh face, ulong modeCount)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var basisAt = call.Use(basis);
                var faceAt = call.Use(face);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(3 * 8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 3 * 8);
                } while ((capacity = call.More(Functions.mien_spectral_project(sessionAt, basisAt, faceAt, modeCount, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows * 3);
            }
        }

        /// <summary>The face that has these spectral coefficients: mean + U c. All other modes are zero.</summary>
        /// <param name="firstMode">the mode of the first row.</param>
        /// <param name="coefficients">row_count x 3 row-major float64, finite</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (modes, not finite), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_spectral_synthesize()</remarks>
        public Mesh SpectralSynthesize(SpectralBasis basis, ulong firstMode, double[] coefficients = null)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var basisAt = call.Use(basis);
                var rowCount = call.Rows(coefficients, 3, "coefficients");
                var coefficientsAt = call.Array(coefficients);
                var outAt = call.Room(8);
                call.Check(Functions.mien_spectral_synthesize(sessionAt, basisAt, coefficientsAt, (ulong)rowCount, firstMode, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>A geometric or perceptual distance. L1, L2 and DAME need correspondence, the others do not.</summary>
        /// <param name="metric">MIEN_METRIC_...</param>
        /// <param name="reference">mm.</param>
        /// <param name="other">mm.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (metric), MIEN_E_MISMATCH (vertex
        /// count or triangles), MIEN_E_INVALID_MESH (no triangles), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_metric()</remarks>
        public double Metric(Metric metric, Mesh reference, Mesh other)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var referenceAt = call.Use(reference);
                var otherAt = call.Use(other);
                var valueAt = call.Room(8);
                call.Check(Functions.mien_metric(sessionAt, (int)metric, referenceAt, otherAt, valueAt, call.Error));
                return *(double*)valueAt;
            }
        }

        /// <summary>Where a distance comes from: one value per vertex of the reference. L1: |dx| + |dy| + |dz|; L2: distance of the
        /// two vertices; Hausdorff: of the vertex from the other surface; DAME: masked change of the dihedral angles around
        /// the vertex, rad; FMPD: how much rougher (above 0) or smoother (below 0) the other looks there, after saturation
        /// and masking.</summary>
        /// <param name="metric">MIEN_METRIC_...</param>
        /// <param name="reference">mm.</param>
        /// <param name="other">mm; the reference's triangles, but for Hausdorff.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (metric), MIEN_E_MISMATCH (vertex
        /// count or triangles), MIEN_E_INVALID_MESH (no triangles), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_metric_field()</remarks>
        public double[] MetricField(Metric metric, Mesh reference, Mesh other)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var referenceAt = call.Use(reference);
                var otherAt = call.Use(other);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_metric_field(sessionAt, (int)metric, referenceAt, otherAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows);
            }
        }

        /// <summary>Local roughness of one mesh, what FMPD is made of: the Laplacian of the angle defect, rad, zero at borders.</summary>
        /// <param name="mesh">with triangles.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (no triangles), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_metric_roughness()</remarks>
        public double[] MetricRoughness(Mesh mesh)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var meshAt = call.Use(mesh);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_metric_roughness(sessionAt, meshAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows);
            }
        }

        /// <summary>Carries an expression from one face to another by deformation transfer.</summary>
        /// <param name="sourceNeutral">#V vertices, mm.</param>
        /// <param name="sourceExpression">the same person with the expression.</param>
        /// <param name="targetNeutral">#V vertices, mm; its triangles hold for all.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_MISMATCH (vertex counts), MIEN_E_INVALID_MESH (no triangles), MIEN_E_NO_SOLUTION,
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_transfer_expression()</remarks>
        public Mesh TransferExpression(Mesh sourceNeutral, Mesh sourceExpression, Mesh targetNeutral)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var sourceNeutralAt = call.Use(sourceNeutral);
                var sourceExpressionAt = call.Use(sourceExpression);
                var targetNeutralAt = call.Use(targetNeutral);
                var outAt = call.Room(8);
                call.Check(Functions.mien_transfer_expression(sessionAt, sourceNeutralAt, sourceExpressionAt, targetNeutralAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>mien_neutralize_mesh() of a registered face: its weights say where the scan had data, its pose is that of the
        /// scan. options.weights, where given, replace the registration's.</summary>
        /// <param name="fitted">registered with the template of the model's training faces.</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">as mien_neutralize_mesh()</exception>
        /// <remarks>C: mien_neutralize()</remarks>
        public Neutralization Neutralize(ExpressionModel model, Registration fitted, NeutralizeOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var modelAt = call.Use(model);
                var fittedAt = call.Use(fitted);
                var optionsAt = (options ?? new NeutralizeOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_neutralize(sessionAt, modelAt, fittedAt, optionsAt, outAt, call.Error));
                return call.Keep(new Neutralization(call.Pointer(outAt)));
            }
        }

        /// <summary>mien_neutralize_mesh() of a registered face: its weights say where the scan had data, its pose is that of the
        /// scan. options.weights, where given, replace the registration's.</summary>
        /// <param name="fitted">registered with the template of the model's training faces.</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">as mien_neutralize_mesh()</exception>
        /// <remarks>C: mien_neutralize()</remarks>
        public Task<Neutralization> NeutralizeAsync(ExpressionModel model, Registration fitted, NeutralizeOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Neutralize(model, fitted, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Takes the expression off a face and keeps everything that the model does not explain.</summary>
        /// <param name="face">in the model's topology, or in a larger one that begins with it (there the displacement runs out smoothly behind
        /// the model's rim); mm.</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a switch or an enumerator that this
        /// library does not know), MIEN_E_MISMATCH (topology, weights), MIEN_E_NO_SOLUTION (MIEN_FIT_EXACT with too little
        /// of the face visible), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_neutralize_mesh()</remarks>
        public Neutralization NeutralizeMesh(ExpressionModel model, Mesh face, NeutralizeOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var modelAt = call.Use(model);
                var faceAt = call.Use(face);
                var optionsAt = (options ?? new NeutralizeOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_neutralize_mesh(sessionAt, modelAt, faceAt, optionsAt, outAt, call.Error));
                return call.Keep(new Neutralization(call.Pointer(outAt)));
            }
        }

        /// <summary>Takes the expression off a face and keeps everything that the model does not explain.</summary>
        /// <param name="face">in the model's topology, or in a larger one that begins with it (there the displacement runs out smoothly behind
        /// the model's rim); mm.</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a switch or an enumerator that this
        /// library does not know), MIEN_E_MISMATCH (topology, weights), MIEN_E_NO_SOLUTION (MIEN_FIT_EXACT with too little
        /// of the face visible), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_neutralize_mesh()</remarks>
        public Task<Neutralization> NeutralizeMeshAsync(ExpressionModel model, Mesh face, NeutralizeOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => NeutralizeMesh(model, face, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Neutralizes every face of a dataset whose subject has a neutral face, and compares.</summary>
        /// <param name="model">in the dataset's topology.</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a fit that this library does not
        /// know), MIEN_E_MISMATCH, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_evaluate_neutralization()</remarks>
        public Evaluation EvaluateNeutralization(ExpressionModel model, string datasetPath, EvaluateOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var modelAt = call.Use(model);
                var datasetPathAt = call.Text(datasetPath);
                var optionsAt = (options ?? new EvaluateOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_evaluate_neutralization(sessionAt, modelAt, datasetPathAt, optionsAt, outAt, call.Error));
                return call.Keep(new Evaluation(call.Pointer(outAt)));
            }
        }

        /// <summary>Neutralizes every face of a dataset whose subject has a neutral face, and compares.</summary>
        /// <param name="model">in the dataset's topology.</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a fit that this library does not
        /// know), MIEN_E_MISMATCH, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_evaluate_neutralization()</remarks>
        public Task<Evaluation> EvaluateNeutralizationAsync(ExpressionModel model, string datasetPath, EvaluateOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => EvaluateNeutralization(model, datasetPath, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Distance of every vertex from the nearest of some vertices, along the surface, by the heat method; a model's
        /// template is a mesh too (mien_model_mesh()). Holes are gone around, edges are not followed.</summary>
        /// <param name="mesh">#V x 3, mm, with triangles.</param>
        /// <param name="sources">source_count vertex numbers.</param>
        /// <param name="options">may be left out: heat stays inside, a time of 4 mean edges squared.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_UNSUPPORTED_OPTION,
        /// MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_geodesic()</remarks>
        public double[] MeasureGeodesic(Mesh mesh, uint[] sources, GeodesicOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Required(sources, "sources");
                call.Lock(this);
                var sessionAt = call.Use(this);
                var meshAt = call.Use(mesh);
                var sourceCount = call.Rows(sources, 1, "sources");
                var sourcesAt = call.Array(sources);
                var optionsAt = (options ?? new GeodesicOptions()).Write(call, progress, cancellationToken);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_measure_geodesic(sessionAt, meshAt, sourcesAt, (ulong)sourceCount, optionsAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows);
            }
        }

        /// <summary>Distance of every vertex from the nearest of some vertices, along the surface, by the heat method; a model's
        /// template is a mesh too (mien_model_mesh()). Holes are gone around, edges are not followed.</summary>
        /// <param name="mesh">#V x 3, mm, with triangles.</param>
        /// <param name="sources">source_count vertex numbers.</param>
        /// <param name="options">may be left out: heat stays inside, a time of 4 mean edges squared.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_UNSUPPORTED_OPTION,
        /// MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_geodesic()</remarks>
        public Task<double[]> MeasureGeodesicAsync(Mesh mesh, uint[] sources, GeodesicOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => MeasureGeodesic(mesh, sources, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>How far raters (or one rater's sessions) agree, as JSON: confusion matrices, percent agreement, Cohen's kappa
        /// plain, linear and quadratic, Fleiss' kappa, all six intraclass correlations, majority grades.</summary>
        /// <param name="ratings">subject_count x rater_count, 0 .. grade_count - 1, negative: missing.</param>
        /// <param name="raterCount">2 to 1000.</param>
        /// <param name="gradeCount">2 to 1000.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (grades, no subject graded by all), MIEN_E_BUFFER_TOO_SMALL,
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_statistics_agreement()</remarks>
        public string StatisticsAgreement(int[] ratings, uint raterCount, int gradeCount)
        {
            using (var call = new Call())
            {
                call.Required(ratings, "ratings");
                call.Lock(this);
                var sessionAt = call.Use(this);
                var subjectCount = call.Rows(ratings, (long) raterCount, "ratings");
                var ratingsAt = call.Array(ratings);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_statistics_agreement(sessionAt, ratingsAt, (ulong)subjectCount, raterCount, gradeCount, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>Within-subject deviation and repeatability coefficient of repeated captures, and the limit of detection from
        /// changes measured where nothing changed, as JSON.</summary>
        /// <param name="subjects">value_count numbers: who was measured.</param>
        /// <param name="values">value_count values</param>
        /// <param name="blanks">blank_count changes measured without any true one; may be left out when 0.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_statistics_repeatability()</remarks>
        public string StatisticsRepeatability(int[] subjects, double[] values = null, double[] blanks = null)
        {
            using (var call = new Call())
            {
                call.Required(subjects, "subjects");
                call.Lock(this);
                var sessionAt = call.Use(this);
                var valueCount = call.Rows(values, 1, "values");
                var valuesAt = call.Array(values);
                call.Agree("subjects", call.Rows(subjects, 1, "subjects"), valueCount);
                var subjectsAt = call.Array(subjects);
                var blankCount = call.Rows(blanks, 1, "blanks");
                var blanksAt = call.Array(blanks);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_statistics_repeatability(sessionAt, valuesAt, subjectsAt, (ulong)valueCount, blanksAt, (ulong)blankCount, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>Bland and Altman's comparison of two methods on the same subjects, as JSON: bias, limits of agreement, their
        /// intervals, and whether the bias grows with the size.</summary>
        /// <param name="first">value_count values.</param>
        /// <param name="second">value_count values.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_statistics_bland_altman()</remarks>
        public string StatisticsBlandAltman(double[] first, double[] second)
        {
            using (var call = new Call())
            {
                call.Required(second, "second");
                call.Required(first, "first");
                call.Lock(this);
                var sessionAt = call.Use(this);
                var valueCount = call.Rows(first, 1, "first");
                var firstAt = call.Array(first);
                call.Agree("second", call.Rows(second, 1, "second"), valueCount);
                var secondAt = call.Array(second);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_statistics_bland_altman(sessionAt, firstAt, secondAt, (ulong)valueCount, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>Neutralizes several scans of one person together: one identity, an expression each.</summary>
        /// <param name="faces">face_count faces in one topology: the model's, or a larger one that begins with it (there the displacement runs
        /// out smoothly behind the model's rim).</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">as mien_neutralize_mesh()</exception>
        /// <remarks>C: mien_neutralize_series()</remarks>
        public Series NeutralizeSeries(ExpressionModel model, IReadOnlyList<Mesh> faces, SeriesOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Required(faces, "faces");
                call.Lock(this);
                var sessionAt = call.Use(this);
                var modelAt = call.Use(model);
                var faceCount = call.Rows(faces, 1, "faces");
                var facesAt = call.Handles(faces);
                var optionsAt = (options ?? new SeriesOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_neutralize_series(sessionAt, modelAt, facesAt, (uint)faceCount, optionsAt, outAt, call.Error));
                return call.Keep(new Series(call.Pointer(outAt)));
            }
        }

        /// <summary>Neutralizes several scans of one person together: one identity, an expression each.</summary>
        /// <param name="faces">face_count faces in one topology: the model's, or a larger one that begins with it (there the displacement runs
        /// out smoothly behind the model's rim).</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">as mien_neutralize_mesh()</exception>
        /// <remarks>C: mien_neutralize_series()</remarks>
        public Task<Series> NeutralizeSeriesAsync(ExpressionModel model, IReadOnlyList<Mesh> faces, SeriesOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => NeutralizeSeries(model, faces, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Looks for what makes a mesh a bad template: size and unit (a face, head or bust in mm), windings (inside out, or
        /// mixed), helpers and other pieces, degenerate and doubled parts, symmetry, and, where landmarks of the 68-point
        /// scheme are given, pose, left and right, closed eyes and mouth. The findings come as JSON text by the two-call
        /// protocol: {"errors": n, "warnings": n, "findings": [{"kind": "error" or "warning", "code", "text", "vertices":
        /// [...]}]}. No model should be built from a mesh with errors; mien_model_build() does not ask.</summary>
        /// <param name="templateMesh">the mesh as it is given to mien_model_build().</param>
        /// <param name="mirror">1: symmetry about x = 0 is asked for, as by options.mirror_symmetric; 0.</param>
        /// <param name="landmarks">may be left out; vertices of the mesh.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (a landmark that is no vertex of the mesh),
        /// MIEN_E_UNSUPPORTED_OPTION (mirror), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_template_check()</remarks>
        public string TemplateCheck(Mesh templateMesh, int mirror, Landmarks landmarks = null)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var templateMeshAt = call.Use(templateMesh);
                var landmarksAt = call.UseOrNull(landmarks);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_template_check(sessionAt, templateMeshAt, landmarksAt, mirror, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>Writes a shard: what a part of a dataset contributes to training, for a cluster's scheduler. Parts are made by
        /// subject, every part_count-th of the sorted subject numbers.</summary>
        /// <param name="shardPath">written atomically.</param>
        /// <param name="options">may be left out: the whole dataset.</param>
        /// <exception cref="MienException">as mien_expression_model_train(); MIEN_E_INVALID_ARGUMENT for a part that does not exist or is empty</exception>
        /// <remarks>C: mien_expression_shard_create()</remarks>
        public void ExpressionShardCreate(string datasetPath, string shardPath, ShardOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var datasetPathAt = call.Text(datasetPath);
                var optionsAt = (options ?? new ShardOptions()).Write(call, progress, cancellationToken);
                var shardPathAt = call.Text(shardPath);
                call.Check(Functions.mien_expression_shard_create(sessionAt, datasetPathAt, optionsAt, shardPathAt, call.Error));
            }
        }

        /// <summary>Writes a shard: what a part of a dataset contributes to training, for a cluster's scheduler. Parts are made by
        /// subject, every part_count-th of the sorted subject numbers.</summary>
        /// <param name="shardPath">written atomically.</param>
        /// <param name="options">may be left out: the whole dataset.</param>
        /// <exception cref="MienException">as mien_expression_model_train(); MIEN_E_INVALID_ARGUMENT for a part that does not exist or is empty</exception>
        /// <remarks>C: mien_expression_shard_create()</remarks>
        public Task ExpressionShardCreateAsync(string datasetPath, string shardPath, ShardOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => ExpressionShardCreate(datasetPath, shardPath, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Takes the expressions off faces of one person, first visit first, so that the neutral faces are in
        /// correspondence along the skin and differ by what changed. The right road to a volume over time: fitted templates
        /// slide along the skin, and mien_neutralize() takes a part of the slide for expression.</summary>
        /// <param name="faces">face_count fitted faces, mm, in one topology: the model's, or a larger one that begins with it (there the
        /// displacement runs out smoothly behind the model's rim).</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a pose that this library does not
        /// know), MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (topology, weights, treated vertices), MIEN_E_NO_SOLUTION,
        /// MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_neutralize_visits()</remarks>
        public Visits NeutralizeVisits(ExpressionModel model, IReadOnlyList<Mesh> faces, VisitsOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Required(faces, "faces");
                call.Lock(this);
                var sessionAt = call.Use(this);
                var modelAt = call.Use(model);
                var faceCount = call.Rows(faces, 1, "faces");
                var facesAt = call.Handles(faces);
                var optionsAt = (options ?? new VisitsOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_neutralize_visits(sessionAt, modelAt, facesAt, (uint)faceCount, optionsAt, outAt, call.Error));
                return call.Keep(new Visits(call.Pointer(outAt)));
            }
        }

        /// <summary>Takes the expressions off faces of one person, first visit first, so that the neutral faces are in
        /// correspondence along the skin and differ by what changed. The right road to a volume over time: fitted templates
        /// slide along the skin, and mien_neutralize() takes a part of the slide for expression.</summary>
        /// <param name="faces">face_count fitted faces, mm, in one topology: the model's, or a larger one that begins with it (there the
        /// displacement runs out smoothly behind the model's rim).</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a pose that this library does not
        /// know), MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (topology, weights, treated vertices), MIEN_E_NO_SOLUTION,
        /// MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_neutralize_visits()</remarks>
        public Task<Visits> NeutralizeVisitsAsync(ExpressionModel model, IReadOnlyList<Mesh> faces, VisitsOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => NeutralizeVisits(model, faces, options, progress, cancellationToken), cancellationToken);
        }
    }
}
