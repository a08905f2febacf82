// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>The plane between left and right. NaN where a number is not known.</summary>
    public sealed unsafe class MirrorPlane
    {
        /// <summary>MIEN_MIRROR_BY_*</summary>
        public MirrorBy By { get; internal set; }
        /// <summary>of partners that counted</summary>
        public ulong Pairs { get; internal set; }
        /// <summary>unit, to the subject's left</summary>
        public double[] Normal { get; internal set; }
        /// <summary>mm, in the plane</summary>
        public double[] Centre { get; internal set; }
        /// <summary>of the distances between a side and the other's reflection</summary>
        public double RmsMm { get; internal set; }
        /// <summary>about either direction of the plane, root mean square</summary>
        public double TiltSdRad { get; internal set; }
        /// <summary>along the normal</summary>
        public double OffsetSdMm { get; internal set; }
        /// <summary>angle to the plane found the other way; NaN without landmarks</summary>
        public double BetweenRad { get; internal set; }
        /// <summary>of that plane from the centre, along its normal</summary>
        public double ApartMm { get; internal set; }

        internal static MirrorPlane Read(Call call, IntPtr at)
        {
            var raw = (Native.MirrorPlane*)at;
            var made = new MirrorPlane();
            made.By = (MirrorBy)raw->by;
            made.Pairs = raw->pairs;
            made.Normal = Call.CopyOut(raw->normal, 3);
            made.Centre = Call.CopyOut(raw->centre, 3);
            made.RmsMm = raw->rmsMm;
            made.TiltSdRad = raw->tiltSdRad;
            made.OffsetSdMm = raw->offsetSdMm;
            made.BetweenRad = raw->betweenRad;
            made.ApartMm = raw->apartMm;
            return made;
        }
    }
}
