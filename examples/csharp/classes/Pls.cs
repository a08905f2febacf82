// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Which algorithm finds the latent variables; with one score both give the same regression.</summary>
    public enum Pls
    {
        Nipals = 0,
        Simpls = 1,
    }
}
