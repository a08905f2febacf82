// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>Scans to be fitted side by side with one model, and their fits.</summary>
    public sealed unsafe class Batch : NativeObject
    {
        internal Batch(IntPtr owned) : base(owned, at => Functions.mien_batch_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public Batch Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_batch_retain(at);
                return new Batch(at);
            }
        }

        /// <summary>An empty batch for a model.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_batch_create()</remarks>
        public static Batch Create(Session session, Model model)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(model);
                var outAt = call.Room(8);
                call.Check(Functions.mien_batch_create(sessionAt, modelAt, outAt, call.Error));
                return call.Keep(new Batch(call.Pointer(outAt)));
            }
        }

        /// <summary>Adds a scan with its own options. The mesh is kept until the scan has been fitted.</summary>
        /// <param name="scan">as for mien_register().</param>
        /// <param name="options">may be left out: no landmarks, all defaults. progress and cancel are not read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (landmarks of which the model knows none),
        /// MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_batch_add()</remarks>
        public void Add(Session session, Mesh scan, RegisterOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(session);
                call.Lock(this);
                var sessionAt = call.Use(session);
                var batchAt = call.Use(this);
                var scanAt = call.Use(scan);
                var optionsAt = (options ?? new RegisterOptions()).Write(call, progress, cancellationToken);
                call.Check(Functions.mien_batch_add(sessionAt, batchAt, scanAt, optionsAt, call.Error));
            }
        }

        /// <summary>Adds a scan with its own options. The mesh is kept until the scan has been fitted.</summary>
        /// <param name="scan">as for mien_register().</param>
        /// <param name="options">may be left out: no landmarks, all defaults. progress and cancel are not read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (landmarks of which the model knows none),
        /// MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_batch_add()</remarks>
        public Task AddAsync(Session session, Mesh scan, RegisterOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Add(session, scan, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Fits all scans that were added and not yet fitted, each on one thread and as many at a time as the session has
        /// threads; each with the bits of mien_register(). A scan that cannot be fitted does not end the others:
        /// mien_batch_get_registration() says why. Memory is that of as many scans as threads, and of the fits.</summary>
        /// <param name="options">may be left out: all defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED,
        /// MIEN_E_CALLBACK; then no scan of this call is fitted</exception>
        /// <remarks>C: mien_batch_run()</remarks>
        public void Run(Session session, BatchOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(session);
                call.Lock(this);
                var sessionAt = call.Use(session);
                var batchAt = call.Use(this);
                var optionsAt = (options ?? new BatchOptions()).Write(call, progress, cancellationToken);
                call.Check(Functions.mien_batch_run(sessionAt, batchAt, optionsAt, call.Error));
            }
        }

        /// <summary>Fits all scans that were added and not yet fitted, each on one thread and as many at a time as the session has
        /// threads; each with the bits of mien_register(). A scan that cannot be fitted does not end the others:
        /// mien_batch_get_registration() says why. Memory is that of as many scans as threads, and of the fits.</summary>
        /// <param name="options">may be left out: all defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED,
        /// MIEN_E_CALLBACK; then no scan of this call is fitted</exception>
        /// <remarks>C: mien_batch_run()</remarks>
        public Task RunAsync(Session session, BatchOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Run(session, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>How many scans were added, and how many of them were run.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_batch_get_counts()</remarks>
        public BatchCounts GetCounts()
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var batchAt = call.Use(this);
                var scanCountAt = call.Room(8);
                var runCountAt = call.Room(8);
                call.Check(Functions.mien_batch_get_counts(batchAt, scanCountAt, runCountAt, call.Error));
                return new BatchCounts(*(uint*)scanCountAt, *(uint*)runCountAt);
            }
        }

        /// <summary>The fit of one scan, or the error that it ended with.</summary>
        /// <param name="index">0 to run_count - 1, in the order of mien_batch_add().</param>
        /// <exception cref="MienException">as mien_register(), MIEN_E_NOT_FOUND (no such scan, or it was not run)</exception>
        /// <remarks>C: mien_batch_get_registration()</remarks>
        public Registration GetRegistration(int index)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var batchAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_batch_get_registration(batchAt, index, outAt, call.Error));
                return call.Keep(new Registration(call.Pointer(outAt)));
            }
        }
    }
}
