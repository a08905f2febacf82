// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>A named place on a scan, read in place and only during the call.</summary>
    public sealed unsafe class ScanLandmark : Record
    {
        /// <summary>matched with the names stored in the model</summary>
        public string Name { get; set; }
        /// <summary>in the scan's frame and unit</summary>
        public double[] Position { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.ScanLandmark*)at;
            raw->name = call.Text(Name);
            Call.CopyIn(Position, raw->position, 3, "position");
        }
    }
}
