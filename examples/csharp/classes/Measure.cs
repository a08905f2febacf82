// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Kinds of measurements.</summary>
    public enum Measure
    {
        /// <summary>straight, mm</summary>
        Length = 1,
        /// <summary>along the skin, mm</summary>
        SurfaceLength = 2,
        /// <summary>degrees</summary>
        Angle = 3,
        /// <summary>signed, of one line against another, degrees</summary>
        Inclination = 4,
        /// <summary>percent</summary>
        Proportion = 5,
        /// <summary>signed distance from a line, mm</summary>
        LineOffset = 6,
    }
}
