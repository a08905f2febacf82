// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Names are those of zones.</summary>
    public sealed unsafe class StudyOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public StudyOptions()
        {
            Library.Need();
            var raw = default(Native.StudyOptions);
            Functions.mien_study_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.StudyOptions));
            MarginMm = raw.marginMm;
            Level = raw.level;
            NoiseMm = raw.noiseMm;
            CorrelationLengthMm = raw.correlationLengthMm;
            CommonBiasMm = raw.commonBiasMm;
            UntrainedShare = raw.untrainedShare;
            MinSeenShare = raw.minSeenShare;
            MeasureUnseen = raw.measureUnseen;
        }

        /// <summary>zone_count zones to measure; null: those of the registrations' model</summary>
        public IReadOnlyList<Zone> Zones { get; set; }
        /// <summary>treated_count names: where the person may have changed, no witness of expression or pose; null: none</summary>
        public IReadOnlyList<string> TreatedZones { get; set; }
        /// <summary>stable_count names of zones to align on; null: all but the treated ones when zones are treated and expressions
        /// taken off, otherwise "forehead" and "nose"; without any zone the whole face</summary>
        public IReadOnlyList<string> StableZones { get; set; }
        /// <summary>visit_number_count numbers, the visit of each face, from 0 and ascending: several captures of one visit tell the
        /// limits of detection; null: each face is a visit of its own</summary>
        public int[] Visits { get; set; }
        /// <summary>around the treated zones, 0 to 100, measured with them as zones of their own at the end; default 10</summary>
        public double MarginMm { get; set; }
        /// <summary>of the intervals, above 0 and below 1; default 0.95</summary>
        public double Level { get; set; }
        /// <summary>of a scanner's surface along its normal, where it was seen; default 0.08</summary>
        public double NoiseMm { get; set; }
        /// <summary>over which the errors of a fitted surface go together; default 4</summary>
        public double CorrelationLengthMm { get; set; }
        /// <summary>error common to all vertices; default 0.01</summary>
        public double CommonBiasMm { get; set; }
        /// <summary>of the volume that an expression accounted for: what no training set knew of it; default 0.06</summary>
        public double UntrainedShare { get; set; }
        /// <summary>of a zone's area that both visits must have seen, 0 to 1; default 0.1</summary>
        public double MinSeenShare { get; set; }
        /// <summary>1: zones keep what no scan saw, which fits guess: walls in nostrils, lips and lids, skin unseen in every visit;
        /// default 0: left out of the zones</summary>
        public int MeasureUnseen { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.StudyOptions*)at;
            Functions.mien_study_options_init(at, (UIntPtr)sizeof(Native.StudyOptions));
            raw->marginMm = MarginMm;
            raw->level = Level;
            raw->noiseMm = NoiseMm;
            raw->correlationLengthMm = CorrelationLengthMm;
            raw->commonBiasMm = CommonBiasMm;
            raw->untrainedShare = UntrainedShare;
            raw->minSeenShare = MinSeenShare;
            raw->measureUnseen = MeasureUnseen;
            raw->zones = call.Records(Zones, sizeof(Native.Zone));
            raw->zoneCount = (ulong)call.Rows(Zones, 1, "zones");
            raw->treatedZones = call.Texts(TreatedZones);
            raw->treatedCount = (ulong)call.Rows(TreatedZones, 1, "treated_zones");
            raw->stableZones = call.Texts(StableZones);
            raw->stableCount = (ulong)call.Rows(StableZones, 1, "stable_zones");
            raw->visits = call.Array(Visits);
            raw->visitNumberCount = (ulong)call.Rows(Visits, 1, "visits");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.StudyOptions));
            Fill(call, at);
            var raw = (Native.StudyOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }
}
