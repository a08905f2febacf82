// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Tells a running call to stop. Thread-safe, sticky, single-use.</summary>
    public sealed unsafe class Cancel : NativeObject
    {
        internal Cancel(IntPtr owned) : base(owned, at => Functions.mien_cancel_release(at)) { }

        /// <summary>Makes a cancel token: name it in the options of one call, request it from any thread.</summary>
        public Cancel() : base(Create()) { }

        /// <summary>Makes a cancel token: name it in the options of one call, request it from any thread.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_cancel_create()</remarks>
        public static Cancel Create()
        {
            using (var call = new Call())
            {
                var outAt = call.Room(8);
                call.Check(Functions.mien_cancel_create(outAt, call.Error));
                return call.Keep(new Cancel(call.Pointer(outAt)));
            }
        }

        /// <summary>Asks the call that was given this token to return MIEN_E_CANCELLED soon. Sticky.</summary>
        /// <remarks>C: mien_cancel_request()</remarks>
        public void Request()
        {
            using (var call = new Call())
            {
                var cancelAt = call.Use(this);
                Functions.mien_cancel_request(cancelAt);
            }
        }
    }
}
