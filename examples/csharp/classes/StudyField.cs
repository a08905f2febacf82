// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Fields with one value per vertex of a visit's face.</summary>
    public enum StudyField
    {
        /// <summary>how far the fitted surface may lie off the skin</summary>
        NormalSdMm = 1,
        /// <summary>in [0, 1]: how far the scan was seen there</summary>
        Weight = 2,
        /// <summary>of the expression that was taken off: root of the summed posterior variance of a place's coordinates</summary>
        ExpressionSdMm = 3,
    }
}
