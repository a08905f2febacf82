// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>mien_session_options of the C interface.</summary>
    public sealed unsafe class SessionOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public SessionOptions()
        {
            Library.Need();
            var raw = default(Native.SessionOptions);
            Functions.mien_session_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.SessionOptions));
            NumThreads = raw.numThreads;
            MaxBytes = raw.maxBytes;
            MaxSeconds = raw.maxSeconds;
            CopyFiles = raw.copyFiles;
        }

        /// <summary>1 (default) to 256; 1 starts no thread. Results do not depend on it.</summary>
        public int NumThreads { get; set; }
        /// <summary>memory budget of one call, 0 (default): none. Counted while the call runs, over all that the library's own code
        /// allocates, the result included; MIEN_E_MEMORY_BUDGET before it would be exceeded. Mapped files do not count.</summary>
        public ulong MaxBytes { get; set; }
        /// <summary>null (default): silent. The library never prints.</summary>
        public Action<int, string> Log { get; set; }
        /// <summary>time limit of one call, 0 (default): none, to 1e8; after it a call ends with MIEN_E_TIME_LIMIT as soon as it
        /// would end for a cancel token. Since 0.2.</summary>
        public double MaxSeconds { get; set; }
        /// <summary>0 (default): model files and datasets are mapped, and a file that another program shortens meanwhile may end the
        /// process (as with any mapping; one that is replaced by renaming, as the library writes, is safe); 1: they are
        /// read into memory. Since 0.2.</summary>
        public int CopyFiles { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.SessionOptions*)at;
            Functions.mien_session_options_init(at, (UIntPtr)sizeof(Native.SessionOptions));
            raw->numThreads = NumThreads;
            raw->maxBytes = MaxBytes;
            raw->maxSeconds = MaxSeconds;
            raw->copyFiles = CopyFiles;
            raw->log = call.LogFunction(Log);
            raw->logUser = call.LogUser(Log);
        }
    }
}
