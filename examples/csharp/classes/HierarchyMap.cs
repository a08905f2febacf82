// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class HierarchyMap
    {
        internal HierarchyMap(uint[] rows, uint[] columns, double[] values, ulong rowCount, ulong columnCount)
        {
            Rows = rows;
            Columns = columns;
            Values = values;
            RowCount = rowCount;
            ColumnCount = columnCount;
        }

        /// <summary>numbers of vertices that the map ends at.</summary>
        public uint[] Rows { get; private set; }
        /// <summary>numbers of vertices that it starts from.</summary>
        public uint[] Columns { get; private set; }
        /// <summary>float64.</summary>
        public double[] Values { get; private set; }
        /// <summary>may be left out; vertices that the map ends at.</summary>
        public ulong RowCount { get; private set; }
        /// <summary>may be left out; vertices that it starts from.</summary>
        public ulong ColumnCount { get; private set; }
    }
}
