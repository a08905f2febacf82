// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What one unit of the scan is.</summary>
    public enum Units
    {
        /// <summary>metres, deci- and centimetres and inches are recognised by size and scaled</summary>
        Detect = 0,
        Millimetres = 1,
        /// <summary>anything that does not look like millimetres is an error</summary>
        Refuse = 2,
    }
}
