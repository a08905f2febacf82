// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What is told of a frame.</summary>
    public sealed unsafe class FollowState
    {
        /// <summary>MIEN_FOLLOW_*</summary>
        public Follow State { get; internal set; }
        /// <summary>0 to 1: of the vertices that face the camera, those on the surface</summary>
        public double Share { get; internal set; }
        /// <summary>mean distance of these from it</summary>
        public double ResidualMm { get; internal set; }
        /// <summary>median way of the vertices along the skin since the start: expressions move a part of a face, sliding moves most
        /// of it</summary>
        public double SlideMm { get; internal set; }

        internal static FollowState Read(Call call, IntPtr at)
        {
            var raw = (Native.FollowState*)at;
            var made = new FollowState();
            made.State = (Follow)raw->state;
            made.Share = raw->share;
            made.ResidualMm = raw->residualMm;
            made.SlideMm = raw->slideMm;
            return made;
        }
    }
}
