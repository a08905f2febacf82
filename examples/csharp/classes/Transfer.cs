// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What mien_surface_transfer_json() carries over.</summary>
    public enum Transfer
    {
        Landmarks = 1,
        Zones = 2,
    }
}
