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
        /// <summary>may be left out; looked at between layers</summary>
        public Cancel Cancel { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.NetworkOptions*)at;
            Functions.mien_network_options_init(at, (UIntPtr)sizeof(Native.NetworkOptions));
            raw->cancel = call.UseOrNull(Cancel);
        }
    }
}
