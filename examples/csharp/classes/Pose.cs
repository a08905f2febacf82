// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Where a face lies against the training faces.</summary>
    public enum Pose
    {
        /// <summary>on the model's stable zone where it has one; else rigid when the face lies more than 3 degrees or 8 mm away from
        /// the mean face and a rigid motion explains it clearly better, else kept</summary>
        Auto = 0,
        /// <summary>in the training's frame</summary>
        Keep = 1,
        /// <summary>anywhere: a rigid motion is fitted together with the face</summary>
        Rigid = 2,
    }
}
