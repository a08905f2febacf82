// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What is known of a landmark.</summary>
    public enum Mark
    {
        /// <summary>null, not a number, "not defined" or a placeholder in its file</summary>
        NotPicked = 0,
        Place = 1,
        Vertex = 2,
    }
}
