// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What comes out of one call.</summary>
    public sealed class NeutralizationCoordinates
    {
        internal NeutralizationCoordinates(double[] identity, double[] expression)
        {
            Identity = identity;
            Expression = expression;
        }

        /// <summary>identity_modes values.</summary>
        public double[] Identity { get; private set; }
        /// <summary>expression_modes values.</summary>
        public double[] Expression { get; private set; }
    }
}
