// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>A scan that was cleaned, wound, weighed and put into a search tree, for any number of models and fits.
    /// Immutable: share freely.</summary>
    public sealed unsafe class ReadyScan : NativeObject
    {
        internal ReadyScan(IntPtr owned) : base(owned, at => Functions.mien_ready_scan_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public ReadyScan Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_ready_scan_retain(at);
                return new ReadyScan(at);
            }
        }

        /// <summary>Prepares a scan once. Its unit is that of the options, or told by its size; no face is looked for.</summary>
        /// <param name="scan">as for mien_register().</param>
        /// <param name="options">may be left out: defaults. Of it units, unit_to_mm, scan_weights, skin_weights, progress and cancel are read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (scan_weights),
        /// MIEN_E_UNSUPPORTED_OPTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED, MIEN_E_CALLBACK</exception>
        /// <remarks>C: mien_ready_scan_create()</remarks>
        public static ReadyScan Create(Session session, Mesh scan, RegisterOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var scanAt = call.Use(scan);
                var optionsAt = (options ?? new RegisterOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_ready_scan_create(sessionAt, scanAt, optionsAt, outAt, call.Error));
                return call.Keep(new ReadyScan(call.Pointer(outAt)));
            }
        }

        /// <summary>Prepares a scan once. Its unit is that of the options, or told by its size; no face is looked for.</summary>
        /// <param name="scan">as for mien_register().</param>
        /// <param name="options">may be left out: defaults. Of it units, unit_to_mm, scan_weights, skin_weights, progress and cancel are read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (scan_weights),
        /// MIEN_E_UNSUPPORTED_OPTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED, MIEN_E_CALLBACK</exception>
        /// <remarks>C: mien_ready_scan_create()</remarks>
        public static Task<ReadyScan> CreateAsync(Session session, Mesh scan, RegisterOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Create(session, scan, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>mien_register() of a prepared scan: the same bits where the scan's unit is known or that which its size tells.</summary>
        /// <param name="options">may be left out: no landmarks, all defaults. What mien_ready_scan_create() reads is not read again, but for
        /// progress and cancel.</param>
        /// <exception cref="MienException">as mien_register()</exception>
        /// <remarks>C: mien_ready_scan_register()</remarks>
        public Registration Register(Session session, Model model, RegisterOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(model);
                var scanAt = call.Use(this);
                var optionsAt = (options ?? new RegisterOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_ready_scan_register(sessionAt, modelAt, scanAt, optionsAt, outAt, call.Error));
                return call.Keep(new Registration(call.Pointer(outAt)));
            }
        }

        /// <summary>mien_register() of a prepared scan: the same bits where the scan's unit is known or that which its size tells.</summary>
        /// <param name="options">may be left out: no landmarks, all defaults. What mien_ready_scan_create() reads is not read again, but for
        /// progress and cancel.</param>
        /// <exception cref="MienException">as mien_register()</exception>
        /// <remarks>C: mien_ready_scan_register()</remarks>
        public Task<Registration> RegisterAsync(Session session, Model model, RegisterOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Register(session, model, options, progress, cancellationToken), cancellationToken);
        }
    }
}
