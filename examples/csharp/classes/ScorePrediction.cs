// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>A predicted score.</summary>
    public sealed unsafe class ScorePrediction
    {
        /// <summary>1: the face is unlike the training faces</summary>
        public int Extrapolates { get; internal set; }
        public double Score { get; internal set; }
        /// <summary>95 % prediction interval</summary>
        public double Low95 { get; internal set; }
        public double High95 { get; internal set; }
        /// <summary>distance from the training faces, about components / faces on average</summary>
        public double Leverage { get; internal set; }

        internal static ScorePrediction Read(Call call, IntPtr at)
        {
            var raw = (Native.ScorePrediction*)at;
            var made = new ScorePrediction();
            made.Extrapolates = raw->extrapolates;
            made.Score = raw->score;
            made.Low95 = raw->low95;
            made.High95 = raw->high95;
            made.Leverage = raw->leverage;
            return made;
        }
    }
}
