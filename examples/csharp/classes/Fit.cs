// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>How a face is taken apart into identity and expression.</summary>
    public enum Fit
    {
        /// <summary>prior of one of a few expressions; the default and the best</summary>
        Mixture = 0,
        /// <summary>Gaussian priors</summary>
        Map = 1,
        /// <summary>joint least squares without a prior</summary>
        Exact = 2,
        /// <summary>block relaxation, for reproduction</summary>
        Alternating = 3,
    }
}
