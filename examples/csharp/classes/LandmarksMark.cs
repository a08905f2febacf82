// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class LandmarksMark
    {
        internal LandmarksMark(int where, double position, uint vertex)
        {
            Where = where;
            Position = position;
            Vertex = vertex;
        }

        /// <summary>may be left out; MIEN_MARK_*.</summary>
        public int Where { get; private set; }
        /// <summary>may be left out; x, y and z in the file's unit, zeros unless it is a place.</summary>
        public double Position { get; private set; }
        /// <summary>may be left out; 0 unless it is a vertex.</summary>
        public uint Vertex { get; private set; }
    }
}
