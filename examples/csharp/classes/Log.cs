// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>MIEN_LOG_* of the C interface.</summary>
    public enum Log
    {
        Error = 1,
        Warning = 2,
        Info = 3,
        Debug = 4,
    }
}
