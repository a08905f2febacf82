// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Mass matrices of the Laplacian.</summary>
    public enum Mass
    {
        MixedVoronoi = 0,
        Barycentric = 1,
        /// <summary>bands then follow the triangulation's density; for comparison</summary>
        None = 2,
    }
}
