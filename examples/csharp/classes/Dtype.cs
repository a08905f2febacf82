// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>MIEN_DTYPE_* of the C interface.</summary>
    public enum Dtype
    {
        F32 = 1,
        F64 = 2,
        I32 = 3,
        U32 = 4,
        U8 = 5,
    }
}
