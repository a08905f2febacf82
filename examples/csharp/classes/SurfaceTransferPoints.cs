// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class SurfaceTransferPoints
    {
        internal SurfaceTransferPoints(uint[] triangles, double[] barycentric, double[] positions)
        {
            Triangles = triangles;
            Barycentric = barycentric;
            Positions = positions;
        }

        /// <summary>triangle (cloud: vertex) numbers of `surface`.</summary>
        public uint[] Triangles { get; private set; }
        /// <summary>rows of 3 values.</summary>
        public double[] Barycentric { get; private set; }
        /// <summary>rows of 3 values in mm; a lost place keeps where it was.</summary>
        public double[] Positions { get; private set; }
    }
}
