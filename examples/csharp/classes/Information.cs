// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>What belongs to no object.</summary>
    public static class Information
    {
        /// <summary>The name of a status, e.g. "MIEN_E_IO".</summary>
        /// <param name="status">any value; unknown ones give "MIEN_E_UNKNOWN".</param>
        /// <remarks>C: mien_status_name()</remarks>
        public static string StatusName(int status)
        {
            using (var call = new Call())
            {
                return Text.FromNative(Functions.mien_status_name(status));
            }
        }

        /// <summary>The library's version as MAJOR * 1000000 + MINOR * 1000 + PATCH.</summary>
        /// <remarks>C: mien_version_number()</remarks>
        public static uint VersionNumber()
        {
            using (var call = new Call())
            {
                return Functions.mien_version_number();
            }
        }

        /// <summary>The library's version as text, e.g. "0.2.0".</summary>
        /// <remarks>C: mien_version_string()</remarks>
        public static string VersionString()
        {
            using (var call = new Call())
            {
                return Text.FromNative(Functions.mien_version_string());
            }
        }

        /// <summary>What was built, for bug reports: version, compiler, instruction sets in use on this processor.</summary>
        /// <remarks>C: mien_build_id()</remarks>
        public static string BuildId()
        {
            using (var call = new Call())
            {
                return Text.FromNative(Functions.mien_build_id());
            }
        }
    }
}
