// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>How the number of deformation modes grows over the rounds (jousse-2022 2.5.2.2).</summary>
    public enum Growth
    {
        Constant = 0,
        Linear = 1,
        Exponential = 2,
        Cubic = 3,
    }
}
