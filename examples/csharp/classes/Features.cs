// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Representations.</summary>
    public enum Features
    {
        Euclidean = 1,
        EuclideanStandardised = 2,
        EuclideanNormalised = 3,
        Deformation = 4,
        DeformationNormalised = 5,
        DeformationStandardised = 6,
    }
}
