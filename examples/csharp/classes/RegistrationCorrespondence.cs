// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class RegistrationCorrespondence
    {
        internal RegistrationCorrespondence(uint[] triangles, double[] barycentric)
        {
            Triangles = triangles;
            Barycentric = barycentric;
        }

        /// <summary>numbers.</summary>
        public uint[] Triangles { get; private set; }
        /// <summary>rows of 3 values.</summary>
        public double[] Barycentric { get; private set; }
    }
}
