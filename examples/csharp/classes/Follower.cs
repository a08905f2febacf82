// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>A face that is followed. Changes with each frame: not to be shared between threads.</summary>
    public sealed unsafe class Follower : NativeObject
    {
        internal Follower(IntPtr owned) : base(owned, at => Functions.mien_follower_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public Follower Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_follower_retain(at);
                return new Follower(at);
            }
        }

        /// <summary>Begins to follow a face from a registration, of whatever origin: its fitted mesh becomes the shape that the
        /// model's modes move about.</summary>
        /// <param name="model">of the registration.</param>
        /// <param name="start">in the camera's frame.</param>
        /// <param name="options">may be left out: all defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (the registration is of another template),
        /// MIEN_E_NO_SOLUTION, MIEN_E_UNSUPPORTED_OPTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_follower_create()</remarks>
        public static Follower Create(Session session, Model model, Registration start, FollowOptions options = null)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(model);
                var startAt = call.Use(start);
                var optionsAt = call.Record(options, sizeof(Native.FollowOptions), true, "options");
                var outAt = call.Room(8);
                call.Check(Functions.mien_follower_create(sessionAt, modelAt, startAt, optionsAt, outAt, call.Error));
                return call.Keep(new Follower(call.Pointer(outAt)));
            }
        }

        /// <summary>Fits the next frame. A face that is gone is not an error: it is told as lost, and searched in each frame until
        /// it is found.</summary>
        /// <param name="points">#P x 3, F32 or F64: one point a pixel, row by row, in the camera's frame and the unit of the options; not
        /// finite, or of depth 0: nothing was seen.</param>
        /// <param name="width">pixels in a row, 3 or more.</param>
        /// <param name="height">rows, 3 or more; width x height is the number of points.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (points that are no pinhole camera's), MIEN_E_MISMATCH (width x
        /// height), MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_follower_fit()</remarks>
        public FollowState Fit(Session session, Values points, int width, int height)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                call.Lock(this);
                var sessionAt = call.Use(session);
                var followerAt = call.Use(this);
                var pointsAt = call.View(points, 3, "points");
                var outAt = call.Sized(sizeof(Native.FollowState));
                call.Check(Functions.mien_follower_fit(sessionAt, followerAt, pointsAt, width, height, outAt, call.Error));
                return FollowState.Read(call, outAt);
            }
        }

        /// <summary>The fitted template of the last frame that was not lost: template topology, the camera's frame, millimetres.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_follower_get_mesh()</remarks>
        public Mesh GetMesh()
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var followerAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_follower_get_mesh(followerAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>The head's motion in that frame, from the template's frame to the camera's, as a row-major 4 x 4 matrix.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_follower_get_motion()</remarks>
        public double[] GetMotion()
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var followerAt = call.Use(this);
                var matrixAt = call.Room(16 * 8);
                call.Check(Functions.mien_follower_get_motion(followerAt, matrixAt, call.Error));
                return call.ReadDoubles(matrixAt, 16);
            }
        }
    }
}
