// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What the mirror plane of a face is found by.</summary>
    public enum MirrorBy
    {
        /// <summary>all vertices and their partners, robustly</summary>
        Surface = 0,
        /// <summary>the landmarks and their partners alone</summary>
        Landmarks = 1,
    }
}
