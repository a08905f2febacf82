// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>mien_anthropometry_options of the C interface.</summary>
    public sealed unsafe class AnthropometryOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public AnthropometryOptions()
        {
            Library.Need();
            var raw = default(Native.AnthropometryOptions);
            Functions.mien_anthropometry_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.AnthropometryOptions));
            SlideCorrelationMm = raw.slideCorrelationMm;
            NormalCorrelationMm = raw.normalCorrelationMm;
        }

        /// <summary>#V, mm: deviation of each vertex' place per axis, as MIEN_REGISTRATION_STANDARD_DEVIATION_MM tells it; count 0:
        /// not known, and no deviation</summary>
        public Values PlaceSd { get; set; }
        /// <summary>#V, mm: along the normal, as MIEN_REGISTRATION_NORMAL_DEVIATION_MM tells it; count 0: as place_sd</summary>
        public Values NormalSd { get; set; }
        /// <summary>over which a template slides together along the skin; default 15</summary>
        public double SlideCorrelationMm { get; set; }
        /// <summary>over which it errs together across the skin; default 4</summary>
        public double NormalCorrelationMm { get; set; }
        /// <summary>may be left out: no z-scores</summary>
        public Norms Norms { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.AnthropometryOptions*)at;
            Functions.mien_anthropometry_options_init(at, (UIntPtr)sizeof(Native.AnthropometryOptions));
            raw->placeSd = call.Matrix(PlaceSd, 1, "place_sd");
            raw->normalSd = call.Matrix(NormalSd, 1, "normal_sd");
            raw->slideCorrelationMm = SlideCorrelationMm;
            raw->normalCorrelationMm = NormalCorrelationMm;
            raw->norms = call.UseOrNull(Norms);
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.AnthropometryOptions));
            Fill(call, at);
            var raw = (Native.AnthropometryOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }
}
