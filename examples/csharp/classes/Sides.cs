// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What is done about landmarks whose left and right are exchanged.</summary>
    public enum Sides
    {
        /// <summary>MIEN_E_MISMATCH that names them</summary>
        Refuse = 0,
        /// <summary>exchange them back and say so in the report</summary>
        Mend = 1,
        Ignore = 2,
    }
}
