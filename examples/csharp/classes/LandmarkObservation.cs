// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Where a landmark was seen.</summary>
    public sealed unsafe class LandmarkObservation : Record
    {
        /// <summary>of a landmark of the model; null: `vertex` says which</summary>
        public string Name { get; set; }
        /// <summary>read when name is null</summary>
        public uint Vertex { get; set; }
        /// <summary>mm, in the frame of the template</summary>
        public double[] Position { get; set; }
        /// <summary>standard deviation of each coordinate, &gt;= 0.000001</summary>
        public double NoiseMm { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.LandmarkObservation*)at;
            raw->vertex = Vertex;
            raw->noiseMm = NoiseMm;
            raw->name = call.TextOrNull(Name);
            Call.CopyIn(Position, raw->position, 3, "position");
        }
    }
}
