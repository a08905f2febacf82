// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>How the two subspaces are found.</summary>
    public enum Train
    {
        /// <summary>joint PCA</summary>
        Jpca = 0,
        /// <summary>quasi-orthogonal joint PCA</summary>
        Qojpca = 1,
    }
}
