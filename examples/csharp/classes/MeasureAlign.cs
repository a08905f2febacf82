// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class MeasureAlign
    {
        internal MeasureAlign(ZoneAlignment info, Mesh @out)
        {
            Info = info;
            Out = @out;
        }

        /// <summary>may be left out</summary>
        public ZoneAlignment Info { get; private set; }
        /// <summary>the moved mesh.</summary>
        public Mesh Out { get; private set; }
    }
}
