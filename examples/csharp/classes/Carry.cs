// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>How vertices are carried onto a surface that is not in correspondence.</summary>
    public enum Carry
    {
        ClosestPoint = 1,
        /// <summary>along one direction: a height field's integral</summary>
        Direction = 2,
        VertexNormal = 3,
    }
}
