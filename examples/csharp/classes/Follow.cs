// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What became of the face in a frame.</summary>
    public enum Follow
    {
        Followed = 0,
        /// <summary>hardly seen, or it has slid along its skin</summary>
        Doubtful = 1,
        /// <summary>was lost, and a search found it in this frame</summary>
        FoundAgain = 2,
        /// <summary>the fitted face is that of the last frame that was not lost</summary>
        Lost = 3,
    }
}
