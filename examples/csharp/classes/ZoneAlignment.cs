// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>A rigid alignment on a stable zone and how sure it is.</summary>
    public sealed unsafe class ZoneAlignment
    {
        /// <summary>that counted</summary>
        public ulong Pairs { get; internal set; }
        /// <summary>left over along the normals</summary>
        public double RmsMm { get; internal set; }
        /// <summary>about the centre, root mean square over the axes</summary>
        public double RotationSdRad { get; internal set; }
        /// <summary>per axis, root mean square</summary>
        public double TranslationSdMm { get; internal set; }
        /// <summary>of the zone on the target</summary>
        public double[] Centre { get; internal set; }
        /// <summary>4 x 4 row by row, moving to target</summary>
        public double[] Matrix { get; internal set; }

        internal static ZoneAlignment Read(Call call, IntPtr at)
        {
            var raw = (Native.ZoneAlignment*)at;
            var made = new ZoneAlignment();
            made.Pairs = raw->pairs;
            made.RmsMm = raw->rmsMm;
            made.RotationSdRad = raw->rotationSdRad;
            made.TranslationSdMm = raw->translationSdMm;
            made.Centre = Call.CopyOut(raw->centre, 3);
            made.Matrix = Call.CopyOut(raw->matrix, 16);
            return made;
        }
    }
}
