// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>The measurements of one face. Immutable: share freely.</summary>
    public sealed unsafe class Anthropometry : NativeObject
    {
        internal Anthropometry(IntPtr owned) : base(owned, at => Functions.mien_anthropometry_release(at)) { }

        /// <summary>How many measurements there are, and how many of them have a value.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_anthropometry_get_counts()</remarks>
        public AnthropometryCounts GetCounts()
        {
            using (var call = new Call())
            {
                var anthropometryAt = call.Use(this);
                var countAt = call.Room(8);
                var knownCountAt = call.Room(8);
                call.Check(Functions.mien_anthropometry_get_counts(anthropometryAt, countAt, knownCountAt, call.Error));
                return new AnthropometryCounts(*(ulong*)countAt, *(ulong*)knownCountAt);
            }
        }

        /// <summary>The name of one measurement, such as "n-gn".</summary>
        /// <param name="index">below the count.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index)</exception>
        /// <remarks>C: mien_anthropometry_get_name()</remarks>
        public string GetName(ulong index)
        {
            using (var call = new Call())
            {
                var anthropometryAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_anthropometry_get_name(anthropometryAt, index, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>One measurement.</summary>
        /// <param name="index">below the count.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index)</exception>
        /// <remarks>C: mien_anthropometry_get_value()</remarks>
        public AnthropometricValue GetValue(ulong index)
        {
            using (var call = new Call())
            {
                var anthropometryAt = call.Use(this);
                var outAt = call.Sized(sizeof(Native.AnthropometricValue));
                call.Check(Functions.mien_anthropometry_get_value(anthropometryAt, index, outAt, call.Error));
                return AnthropometricValue.Read(call, outAt);
            }
        }

        /// <summary>Why one measurement has no value, in words; empty where it has one.</summary>
        /// <param name="index">below the count.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index)</exception>
        /// <remarks>C: mien_anthropometry_get_reason()</remarks>
        public string GetReason(ulong index)
        {
            using (var call = new Call())
            {
                var anthropometryAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_anthropometry_get_reason(anthropometryAt, index, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>All measurements as JSON text: name, title, kind, unit, landmarks, source, value, sd, reason, z; and which of
        /// the face's landmarks stand for those of the field.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_anthropometry_get_json()</remarks>
        public string GetJson()
        {
            using (var call = new Call())
            {
                var anthropometryAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_anthropometry_get_json(anthropometryAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }
    }
}
