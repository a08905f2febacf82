// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>How a treated zone is read.</summary>
    public enum Reading
    {
        /// <summary>the zone is no witness: what the result holds</summary>
        Treated = 0,
        /// <summary>all of the face is a witness</summary>
        AsExpression = 1,
    }
}
