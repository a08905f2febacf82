// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What each vertex gives. jousse-2022 (B.2) has 17 numbers a vertex without naming them; ours are displacement
    /// (3), change of the normal (3), k1, k2, mean and Gaussian curvature, curvedness, and the curvature tensor (6),
    /// each of them an equal part of curvature_share.</summary>
    public enum ScoreFeatures
    {
        /// <summary>displacement, k1, k2</summary>
        DisplacementAndCurvature = 0,
        /// <summary>all 17</summary>
        All = 1,
    }
}
