// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>One measurement of a face. NaN where a number is not known.</summary>
    public sealed unsafe class AnthropometricValue
    {
        /// <summary>MIEN_MEASURE_*</summary>
        public Measure Kind { get; internal set; }
        /// <summary>NaN: mien_anthropometry_get_reason() says why</summary>
        public double Value { get; internal set; }
        /// <summary>of the value, by the errors of the landmarks' places</summary>
        public double Sd { get; internal set; }
        /// <summary>(value - norm_mean) / norm_sd</summary>
        public double Z { get; internal set; }
        /// <summary>sd / norm_sd</summary>
        public double ZSd { get; internal set; }
        /// <summary>over the people of the norms</summary>
        public double NormMean { get; internal set; }
        public double NormSd { get; internal set; }
        /// <summary>0: no norm</summary>
        public ulong NormPeople { get; internal set; }

        internal static AnthropometricValue Read(Call call, IntPtr at)
        {
            var raw = (Native.AnthropometricValue*)at;
            var made = new AnthropometricValue();
            made.Kind = (Measure)raw->kind;
            made.Value = raw->value;
            made.Sd = raw->sd;
            made.Z = raw->z;
            made.ZSd = raw->zSd;
            made.NormMean = raw->normMean;
            made.NormSd = raw->normSd;
            made.NormPeople = raw->normPeople;
            return made;
        }
    }
}
