// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Distances between two faces.</summary>
    public enum Metric
    {
        /// <summary>mm: mean of |dx| + |dy| + |dz| over the vertices</summary>
        L1 = 1,
        /// <summary>mm: mean Euclidean distance over the vertices</summary>
        L2 = 2,
        /// <summary>mm: largest distance of a vertex from the other surface, both ways</summary>
        Hausdorff = 3,
        /// <summary>rad: change of the dihedral angles, masked, weighted with area</summary>
        Dame = 4,
        /// <summary>0 to 1: difference of the global roughness</summary>
        Fmpd = 5,
    }
}
