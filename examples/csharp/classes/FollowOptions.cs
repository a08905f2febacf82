// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>mien_follow_options of the C interface.</summary>
    public sealed unsafe class FollowOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public FollowOptions()
        {
            Library.Need();
            var raw = default(Native.FollowOptions);
            Functions.mien_follow_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.FollowOptions));
            Rounds = raw.rounds;
            MaxVertices = raw.maxVertices;
            MaxScalarModes = raw.maxScalarModes;
            MaxPcaModes = raw.maxPcaModes;
            TemporalMm = raw.temporalMm;
            SigmaStartMm = raw.sigmaStartMm;
            SigmaEndMm = raw.sigmaEndMm;
            LostShare = raw.lostShare;
            UnitToMm = raw.unitToMm;
            FocalX = raw.focalX;
            FocalY = raw.focalY;
            CentreX = raw.centreX;
            CentreY = raw.centreY;
        }

        /// <summary>of closest places and a solve, per frame, 1 to 100; default 3</summary>
        public int Rounds { get; set; }
        /// <summary>of the template that pull, 100 or more; default 2500</summary>
        public int MaxVertices { get; set; }
        /// <summary>of the model's kernel modes that move, 0 or more; default 250</summary>
        public int MaxScalarModes { get; set; }
        /// <summary>of the model's trained modes that move, 0 or more; default 60</summary>
        public int MaxPcaModes { get; set; }
        /// <summary>deviation of a vertex from where it was on the head in the frame before; 0: frames know nothing of each other;
        /// default 4</summary>
        public double TemporalMm { get; set; }
        /// <summary>noise level of a surface point in a frame's first round; default 1.5</summary>
        public double SigmaStartMm { get; set; }
        /// <summary>and in its last; default 0.7</summary>
        public double SigmaEndMm { get; set; }
        /// <summary>the face is lost when less of it lies on what the camera sees; 0 to 1, default 0.5</summary>
        public double LostShare { get; set; }
        /// <summary>one unit of the frames' points in mm; default 1</summary>
        public double UnitToMm { get; set; }
        /// <summary>pixels, column = focal_x x / z + centre_x; 0 (default): all four are found from each frame's points</summary>
        public double FocalX { get; set; }
        /// <summary>pixels, row = focal_y y / z + centre_y</summary>
        public double FocalY { get; set; }
        /// <summary>pixels</summary>
        public double CentreX { get; set; }
        /// <summary>pixels</summary>
        public double CentreY { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.FollowOptions*)at;
            Functions.mien_follow_options_init(at, (UIntPtr)sizeof(Native.FollowOptions));
            raw->rounds = Rounds;
            raw->maxVertices = MaxVertices;
            raw->maxScalarModes = MaxScalarModes;
            raw->maxPcaModes = MaxPcaModes;
            raw->temporalMm = TemporalMm;
            raw->sigmaStartMm = SigmaStartMm;
            raw->sigmaEndMm = SigmaEndMm;
            raw->lostShare = LostShare;
            raw->unitToMm = UnitToMm;
            raw->focalX = FocalX;
            raw->focalY = FocalY;
            raw->centreX = CentreX;
            raw->centreY = CentreY;
        }
    }
}
