// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Places of the whole face and of what no zone covers, beside 0 .. zone_count - 1.</summary>
    public enum ZoneKind
    {
        Whole = -1,
        Rest = -2,
    }
}
