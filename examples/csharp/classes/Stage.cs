// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Stages of long work, as a progress callback sees them.</summary>
    public enum Stage
    {
        Reading = 1,
        Geodesics = 2,
        Basis = 3,
        Alignment = 4,
        Fitting = 5,
        Refining = 6,
        Training = 7,
        Neutralizing = 8,
        Measuring = 9,
        Writing = 10,
    }
}
