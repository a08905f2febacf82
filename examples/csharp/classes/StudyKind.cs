// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Why a change has no deviation.</summary>
    public enum StudyKind
    {
        Known = 0,
        /// <summary>too little of the zone was seen: no values either</summary>
        Unseen = 1,
        /// <summary>the fit of one of the visits failed</summary>
        FailedFit = 2,
        /// <summary>a face came without deviations</summary>
        NoSurfaceErrors = 3,
        /// <summary>the zone lies behind the expression model's rim</summary>
        OutsideExpressions = 4,
    }
}
