// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>MIEN_STATUS_* of the C interface.</summary>
    public enum Status
    {
        Ok = 0,
        /// <summary>a parameter is null or out of its range</summary>
        EInvalidArgument = -1,
        /// <summary>a handle is null, released or of another type</summary>
        EInvalidHandle = -2,
        /// <summary>empty, not finite, index out of range, degenerate</summary>
        EInvalidMesh = -3,
        /// <summary>the count was written, nothing else</summary>
        EBufferTooSmall = -4,
        /// <summary>an option, a switch or an enumerator that this library does not know</summary>
        EUnsupportedOption = -5,
        /// <summary>ABI or file format of another major version</summary>
        EUnsupportedVersion = -6,
        /// <summary>an allocation failed; the session stays usable</summary>
        ENoMemory = -7,
        /// <summary>the session's max_bytes would be exceeded</summary>
        EMemoryBudget = -8,
        /// <summary>a file cannot be opened, read or written</summary>
        EIo = -9,
        /// <summary>a file is not what its format says</summary>
        EBadFormat = -10,
        /// <summary>hash mismatch, or values that are not finite</summary>
        ECorrupt = -11,
        /// <summary>a good file of another kind</summary>
        EWrongKind = -12,
        /// <summary>inputs that do not belong together</summary>
        EMismatch = -13,
        /// <summary>a factorisation or an iteration failed</summary>
        ENoSolution = -14,
        /// <summary>an unknown name</summary>
        ENotFound = -15,
        /// <summary>by a progress callback or a cancel token</summary>
        ECancelled = -16,
        /// <summary>a callback unwound</summary>
        ECallback = -17,
        /// <summary>a defect of the library: please report it</summary>
        EInternal = -18,
        /// <summary>the session is in a call on another thread; since 0.2</summary>
        EBusy = -19,
        /// <summary>the session's max_seconds have passed; since 0.2</summary>
        ETimeLimit = -20,
    }
}
