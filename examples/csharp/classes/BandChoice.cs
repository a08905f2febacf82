// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>One tried k of mien_blendshape_model_search().</summary>
    public sealed unsafe class BandChoice : Record
    {
        public ulong K { get; set; }
        public double L1Mm { get; set; }
        public double Dame { get; set; }
        public double Fmpd { get; set; }
        /// <summary>1: no other k is better in both L1 and FMPD</summary>
        public int OnFront { get; set; }
        /// <summary>1: the front's knee</summary>
        public int Chosen { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.BandChoice*)at;
            raw->k = K;
            raw->l1Mm = L1Mm;
            raw->dame = Dame;
            raw->fmpd = Fmpd;
            raw->onFront = OnFront;
            raw->chosen = Chosen;
        }

        internal static BandChoice Read(Call call, IntPtr at)
        {
            var raw = (Native.BandChoice*)at;
            var made = new BandChoice();
            made.K = raw->k;
            made.L1Mm = raw->l1Mm;
            made.Dame = raw->dame;
            made.Fmpd = raw->fmpd;
            made.OnFront = raw->onFront;
            made.Chosen = raw->chosen;
            return made;
        }
    }
}
