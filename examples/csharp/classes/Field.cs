// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Fields with one value per vertex of the before face.</summary>
    public enum Field
    {
        /// <summary>along the normal of the before face</summary>
        SignedDistanceMm = 1,
        /// <summary>length of the displacement or to the closest place</summary>
        DistanceMm = 2,
        PositiveVolumeMm3 = 3,
        NegativeVolumeMm3 = 4,
        /// <summary>1/mm, positive where the surface bulges outwards</summary>
        CurvatureMaximal = 5,
        /// <summary>1/mm</summary>
        CurvatureMinimal = 6,
        /// <summary>1/mm</summary>
        CurvatureMean = 7,
        /// <summary>1/mm^2</summary>
        CurvatureGaussian = 8,
    }
}
