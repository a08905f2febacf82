// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Fields with one value per template vertex.</summary>
    public enum RegistrationKind
    {
        /// <summary>signed distance to the scan, positive: the scan lies outside</summary>
        ResidualMm = 1,
        /// <summary>in [0, 1]: how much of the scan's say counted</summary>
        Weight = 2,
        /// <summary>of the place, per axis (root mean square)</summary>
        StandardDeviationMm = 3,
        /// <summary>the true place lies within, 95 times out of 100: the deviation's pattern in the size of the zone's expected
        /// error (mien_registration_get_expected_error)</summary>
        Radius95Mm = 4,
        /// <summary>how far the surface may lie off the skin along its normal: what mien_measure_options wants. Since 0.2</summary>
        NormalDeviationMm = 5,
        /// <summary>how far mien_registration_tie() moved the place. Since 0.2</summary>
        SlideMm = 6,
        /// <summary>-1 to 1: correlation of both visits' pictures around the place after the slide; 0: not compared. Since 0.2</summary>
        TieAgreement = 7,
        /// <summary>0 to 1: how far the texture holds the place. Since 0.2</summary>
        TieShare = 8,
        /// <summary>between both visits' places along the skin, per axis; 0 where the texture holds nothing. Since 0.2</summary>
        TieDeviationMm = 9,
    }
}
