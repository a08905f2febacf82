// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>How to run; initialise with mien_network_options_init().</summary>
    public sealed unsafe class NetworkOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public NetworkOptions()
        {
            Library.Need();
            var raw = default(Native.NetworkOptions);
            Functions.mien_network_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.NetworkOptions));
            BandLimit = raw.bandLimit;
        }

        /// <summary>may be left out; looked at between layers</summary>
        public Cancel Cancel { get; set; }
        /// <summary>mien_network_apply() of a network that adds an expression in two bands: modes of the low one; default 0: the
        /// file's own; negative: none, deformations alone; more than the file's basis has: coordinates alone</summary>
        public long BandLimit { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.NetworkOptions*)at;
            Functions.mien_network_options_init(at, (UIntPtr)sizeof(Native.NetworkOptions));
            raw->bandLimit = BandLimit;
            raw->cancel = call.UseOrNull(Cancel);
        }
    }
}
