// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>The first Laplace-Beltrami eigenvectors of a mean shape. Immutable: share freely.</summary>
    public sealed unsafe class SpectralBasis : NativeObject
    {
        internal SpectralBasis(IntPtr owned) : base(owned, at => Functions.mien_spectral_basis_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public SpectralBasis Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_spectral_basis_retain(at);
                return new SpectralBasis(at);
            }
        }

        /// <summary>Computes the first eigenpairs of the mean shape's Laplacian by spectrum slicing; inertia counts prove that none
        /// is missing.</summary>
        /// <param name="mean">the mean shape, mm. Any triangle mesh.</param>
        /// <param name="options">may be left out: 500 modes, mixed Voronoi mass, intrinsic Delaunay.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (mode_count), MIEN_E_UNSUPPORTED_OPTION, MIEN_E_INVALID_MESH,
        /// MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_spectral_basis_build()</remarks>
        public static SpectralBasis Build(Session session, Mesh mean, SpectralBasisOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var meanAt = call.Use(mean);
                var optionsAt = (options ?? new SpectralBasisOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_spectral_basis_build(sessionAt, meanAt, optionsAt, outAt, call.Error));
                return call.Keep(new SpectralBasis(call.Pointer(outAt)));
            }
        }

        /// <summary>Computes the first eigenpairs of the mean shape's Laplacian by spectrum slicing; inertia counts prove that none
        /// is missing.</summary>
        /// <param name="mean">the mean shape, mm. Any triangle mesh.</param>
        /// <param name="options">may be left out: 500 modes, mixed Voronoi mass, intrinsic Delaunay.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (mode_count), MIEN_E_UNSUPPORTED_OPTION, MIEN_E_INVALID_MESH,
        /// MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_spectral_basis_build()</remarks>
        public static Task<SpectralBasis> BuildAsync(Session session, Mesh mean, SpectralBasisOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Build(session, mean, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Opens a basis file; the vectors stay in the mapped file.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_WRONG_KIND,
        /// MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_spectral_basis_load()</remarks>
        public static SpectralBasis Load(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_spectral_basis_load(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new SpectralBasis(call.Pointer(outAt)));
            }
        }

        /// <summary>Writes a basis file (safetensors). Atomic.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_spectral_basis_save()</remarks>
        public void Save(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var basisAt = call.Use(this);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_spectral_basis_save(sessionAt, basisAt, pathAt, call.Error));
            }
        }

        /// <summary>Numbers of vertices and modes.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_spectral_basis_get_counts()</remarks>
        public SpectralBasisCounts GetCounts()
        {
            using (var call = new Call())
            {
                var basisAt = call.Use(this);
                var vertexCountAt = call.Room(8);
                var modeCountAt = call.Room(8);
                call.Check(Functions.mien_spectral_basis_get_counts(basisAt, vertexCountAt, modeCountAt, call.Error));
                return new SpectralBasisCounts(*(ulong*)vertexCountAt, *(ulong*)modeCountAt);
            }
        }

        /// <summary>Copies the eigenvalues, ascending, 1/mm^2. With dst null and capacity 0: writes the count only.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_spectral_basis_get_eigenvalues()</remarks>
        public double[] GetEigenvalues()
        {
            using (var call = new Call())
            {
                var basisAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_spectral_basis_get_eigenvalues(basisAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows);
            }
        }

        /// <summary>Copies one eigenvector, U's column: a value per vertex, orthonormal in the mass matrix, so 1/mm (plain without
        /// mass).</summary>
        /// <param name="mode">0 to the basis' modes - 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (mode), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_spectral_basis_get_vector()</remarks>
        public double[] GetVector(ulong mode)
        {
            using (var call = new Call())
            {
                var basisAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_spectral_basis_get_vector(basisAt, mode, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows);
            }
        }

        /// <summary>Copies the diagonal of the mass matrix: mm^2 per vertex, ones without mass.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_spectral_basis_get_mass()</remarks>
        public double[] GetMass()
        {
            using (var call = new Call())
            {
                var basisAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_spectral_basis_get_mass(basisAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows);
            }
        }

        /// <summary>The mean shape that the basis belongs to.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_spectral_basis_get_mean()</remarks>
        public Mesh GetMean()
        {
            using (var call = new Call())
            {
                var basisAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_spectral_basis_get_mean(basisAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }
    }
}
