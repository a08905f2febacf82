// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>A list of named landmarks: places on a scan, or vertices of a template. Immutable: share freely.</summary>
    public sealed unsafe class Landmarks : NativeObject
    {
        internal Landmarks(IntPtr owned) : base(owned, at => Functions.mien_landmarks_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public Landmarks Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_landmarks_retain(at);
                return new Landmarks(at);
            }
        }

        /// <summary>Reads a landmark file, told by its content: this project's JSON ({"points": ...} or {"vertices": ...}), 3D
        /// Slicer's .mrk.json and .fcsv (coordinates come out as LPS), MeshLab's .pp, .pts, menpo's .ljson, tables
        /// name,x,y,z or name,vertex, and vertex numbers alone. What was not picked (null, not a number, "not defined", a
        /// repeated placeholder such as 0 0 0) is kept as such. Landmarks without a name are called by their number, from
        /// "1".</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_MEMORY_BUDGET,
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_landmarks_load()</remarks>
        public static Landmarks Load(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_landmarks_load(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new Landmarks(call.Pointer(outAt)));
            }
        }

        /// <summary>Makes a list of places from the host's. A repeated placeholder, such as 0 0 0, counts as not picked.</summary>
        /// <param name="landmarks">landmark_count of them; null allowed when that is 0. Names must differ.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_landmarks_create()</remarks>
        public static Landmarks Create(IReadOnlyList<ScanLandmark> landmarks = null)
        {
            using (var call = new Call())
            {
                var landmarkCount = call.Rows(landmarks, 1, "landmarks");
                var landmarksAt = call.Records(landmarks, sizeof(Native.ScanLandmark));
                var outAt = call.Room(8);
                call.Check(Functions.mien_landmarks_create(landmarksAt, (ulong)landmarkCount, outAt, call.Error));
                return call.Keep(new Landmarks(call.Pointer(outAt)));
            }
        }

        /// <summary>The landmarks under the names that a model has for them. Case, separators and leading zeros do not count;
        /// numbers alone are read as iBUG-68 (from 0 or 1) or MediaPipe (468 or 478), where the model has the 68 names of
        /// that scheme. What the model does not know is left out and listed in the JSON of the result.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (two names mean one landmark, numbers fit two schemes),
        /// MIEN_E_NOT_FOUND (none is known; the message gives examples of known names), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_landmarks_match()</remarks>
        public Landmarks Match(Model model)
        {
            using (var call = new Call())
            {
                var landmarksAt = call.Use(this);
                var modelAt = call.Use(model);
                var outAt = call.Room(8);
                call.Check(Functions.mien_landmarks_match(landmarksAt, modelAt, outAt, call.Error));
                return call.Keep(new Landmarks(call.Pointer(outAt)));
            }
        }

        /// <summary>The landmarks as places: vertex numbers become the vertices' places on a mesh, places stay as they are.</summary>
        /// <param name="mesh">has the numbered vertices.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (a number that the mesh does not have),
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_landmarks_on_mesh()</remarks>
        public Landmarks OnMesh(Mesh mesh)
        {
            using (var call = new Call())
            {
                var landmarksAt = call.Use(this);
                var meshAt = call.Use(mesh);
                var outAt = call.Room(8);
                call.Check(Functions.mien_landmarks_on_mesh(landmarksAt, meshAt, outAt, call.Error));
                return call.Keep(new Landmarks(call.Pointer(outAt)));
            }
        }

        /// <summary>Writes a landmark file by its extension: .json, .mrk.json and .fcsv (both LPS), .pp, .pts, .ljson, .csv. Vertex
        /// numbers go into .json and .csv. Atomic.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_MEMORY_BUDGET,
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_landmarks_save()</remarks>
        public void Save(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var landmarksAt = call.Use(this);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_landmarks_save(sessionAt, landmarksAt, pathAt, call.Error));
            }
        }

        /// <summary>How many landmarks there are, and how many of them are a place or a vertex.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_landmarks_get_counts()</remarks>
        public LandmarksCounts GetCounts()
        {
            using (var call = new Call())
            {
                var landmarksAt = call.Use(this);
                var countAt = call.Room(8);
                var pickedCountAt = call.Room(8);
                call.Check(Functions.mien_landmarks_get_counts(landmarksAt, countAt, pickedCountAt, call.Error));
                return new LandmarksCounts(*(ulong*)countAt, *(ulong*)pickedCountAt);
            }
        }

        /// <summary>The name of one landmark.</summary>
        /// <param name="index">below the count.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index)</exception>
        /// <remarks>C: mien_landmarks_get_name()</remarks>
        public string GetName(ulong index)
        {
            using (var call = new Call())
            {
                var landmarksAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_landmarks_get_name(landmarksAt, index, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>What is known of one landmark.</summary>
        /// <param name="index">below the count.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (misaligned), MIEN_E_NOT_FOUND (index)</exception>
        /// <remarks>C: mien_landmarks_get_mark()</remarks>
        public LandmarksMark GetMark(ulong index)
        {
            using (var call = new Call())
            {
                var landmarksAt = call.Use(this);
                var whereAt = call.Room(8);
                var positionAt = call.Room(8);
                var vertexAt = call.Room(8);
                call.Check(Functions.mien_landmarks_get_mark(landmarksAt, index, whereAt, positionAt, vertexAt, call.Error));
                return new LandmarksMark(*(int*)whereAt, *(double*)positionAt, *(uint*)vertexAt);
            }
        }

        /// <summary>What the list is, as JSON text by the two-call protocol: format, system (LPS or RAS as the file says it),
        /// unit_to_mm (null: not told), count, picked, not_picked (names), and after mien_landmarks_match() scheme and
        /// unknown (names).</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_landmarks_get_json()</remarks>
        public string GetJson()
        {
            using (var call = new Call())
            {
                var landmarksAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_landmarks_get_json(landmarksAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>The landmarks of a template and, beside them, those of its profile that its shape defines by itself: glabella,
        /// nasion, columella, sublabiale and pogonion, where they are not among the given ones. Every face in the
        /// template's topology has them at the same vertices.</summary>
        /// <param name="templateMesh">symmetric about its plane x = 0, +y up, +z forward (mien_model_mesh()).</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (a landmark that the search starts from),
        /// MIEN_E_MISMATCH (vertex), MIEN_E_INVALID_MESH (not symmetric, no midline), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_landmarks_add_profile()</remarks>
        public Landmarks AddProfile(Mesh templateMesh)
        {
            using (var call = new Call())
            {
                var landmarksAt = call.Use(this);
                var templateMeshAt = call.Use(templateMesh);
                var outAt = call.Room(8);
                call.Check(Functions.mien_landmarks_add_profile(landmarksAt, templateMeshAt, outAt, call.Error));
                return call.Keep(new Landmarks(call.Pointer(outAt)));
            }
        }
    }
}
