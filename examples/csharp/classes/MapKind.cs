// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Directions of a hierarchy's maps.</summary>
    public enum MapKind
    {
        /// <summary>from the next finer level to this one</summary>
        Down = 1,
        /// <summary>from this level to the next finer one</summary>
        Up = 2,
    }
}
