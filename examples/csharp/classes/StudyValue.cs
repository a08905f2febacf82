// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>A number with its error. NaN: not known.</summary>
    public sealed unsafe class StudyValue : Record
    {
        public double Value { get; set; }
        /// <summary>standard deviation</summary>
        public double Sd { get; set; }
        /// <summary>of the interval at the study's level</summary>
        public double Low { get; set; }
        /// <summary>of the interval at the study's level</summary>
        public double High { get; set; }
        /// <summary>the minimal detectable change: a smaller size cannot be told from no change at the study's level, as the
        /// interval holds zero; from repeated captures where there are enough</summary>
        public double LimitOfDetection { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.StudyValue*)at;
            raw->value = Value;
            raw->sd = Sd;
            raw->low = Low;
            raw->high = High;
            raw->limitOfDetection = LimitOfDetection;
        }

        internal static StudyValue Read(Call call, IntPtr at)
        {
            var raw = (Native.StudyValue*)at;
            var made = new StudyValue();
            made.Value = raw->value;
            made.Sd = raw->sd;
            made.Low = raw->low;
            made.High = raw->high;
            made.LimitOfDetection = raw->limitOfDetection;
            return made;
        }
    }
}
