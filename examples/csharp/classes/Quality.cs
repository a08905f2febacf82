// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>How far a fit is to be trusted.</summary>
    public enum Quality
    {
        Good = 0,
        Doubtful = 1,
        Failed = 2,
    }
}
