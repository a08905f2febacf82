// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class MeasurementZones
    {
        internal MeasurementZones(uint zoneCount, int zonesDisjoint)
        {
            ZoneCount = zoneCount;
            ZonesDisjoint = zonesDisjoint;
        }

        /// <summary>may be left out; the number of zones given.</summary>
        public uint ZoneCount { get; private set; }
        /// <summary>may be left out; 1 when no vertex lies in two zones: zones and rest then add up.</summary>
        public int ZonesDisjoint { get; private set; }
    }
}
