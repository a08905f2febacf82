// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What to do with negative cotangent weights.</summary>
    public enum Cotangents
    {
        IntrinsicDelaunay = 0,
        Clamp = 1,
        Keep = 2,
    }
}
