// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What the heat of the heat method does at borders of the template.</summary>
    public enum Heat
    {
        /// <summary>stays inside</summary>
        Neumann = 1,
        /// <summary>is cooled to zero</summary>
        Dirichlet = 2,
        /// <summary>half of each</summary>
        Average = 3,
    }
}
