// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Kernels: what makes two vertices of the template move alike.</summary>
    public enum KernelKind
    {
        /// <summary>no kernel: modes from faces alone (needs pca_dataset)</summary>
        None = 0,
        /// <summary>squared exponential of the straight distance</summary>
        EuclideanSe = 1,
        /// <summary>of the distance along the surface: mouth and eyes may open</summary>
        GeodesicSe = 2,
        /// <summary>cubic B-splines on a grid in space</summary>
        Bspline = 3,
        /// <summary>Matern along the surface, positive definite by construction</summary>
        SurfaceMatern = 4,
    }
}
