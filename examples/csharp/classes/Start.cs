// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Where a fit begins.</summary>
    public enum Start
    {
        /// <summary>landmarks when three match, else a search</summary>
        Automatic = 0,
        Landmarks = 1,
        /// <summary>start_rotation, start_translation, start_scale</summary>
        Pose = 2,
        /// <summary>over all poses, those up to 60 degrees off frontal first</summary>
        Search = 3,
    }
}
