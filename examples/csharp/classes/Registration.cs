// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>A fitted template: places, residuals, confidence, verdict. Immutable: share freely.</summary>
    public sealed unsafe class Registration : NativeObject
    {
        internal Registration(IntPtr owned) : base(owned, at => Functions.mien_registration_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public Registration Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_registration_retain(at);
                return new Registration(at);
            }
        }

        /// <summary>The fitted template: template topology, the scan's frame, millimetres.</summary>
        /// <remarks>C: mien_registration_mesh()</remarks>
        public Mesh GetMesh()
        {
            using (var call = new Call())
            {
                var registrationAt = call.Use(this);
                var lent = Functions.mien_registration_mesh(registrationAt);
                Functions.mien_mesh_retain(lent);
                return new Mesh(lent);
            }
        }

        /// <summary>The verdict.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_registration_get_verdict()</remarks>
        public FitVerdict GetVerdict()
        {
            using (var call = new Call())
            {
                var registrationAt = call.Use(this);
                var outAt = call.Sized(sizeof(Native.FitVerdict));
                call.Check(Functions.mien_registration_get_verdict(registrationAt, outAt, call.Error));
                return FitVerdict.Read(call, outAt);
            }
        }

        /// <summary>The error that is expected of a zone of the model, or of the whole face.</summary>
        /// <param name="zone">a zone of the model by its name; null: the whole face.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (no such zone, or the registration was made of
        /// arrays or read from a file that states none)</exception>
        /// <remarks>C: mien_registration_get_expected_error()</remarks>
        public ExpectedError GetExpectedError(string zone = null)
        {
            using (var call = new Call())
            {
                var registrationAt = call.Use(this);
                var zoneAt = call.TextOrNull(zone);
                var outAt = call.Sized(sizeof(Native.ExpectedError));
                call.Check(Functions.mien_registration_get_expected_error(registrationAt, zoneAt, outAt, call.Error));
                return ExpectedError.Read(call, outAt);
            }
        }

        /// <summary>Copies a field with one float64 per template vertex.</summary>
        /// <param name="field">one of MIEN_REGISTRATION_RESIDUAL_MM, MIEN_REGISTRATION_WEIGHT, MIEN_REGISTRATION_STANDARD_DEVIATION_MM,
        /// MIEN_REGISTRATION_RADIUS95_MM, MIEN_REGISTRATION_NORMAL_DEVIATION_MM, MIEN_REGISTRATION_SLIDE_MM,
        /// MIEN_REGISTRATION_TIE_AGREEMENT, MIEN_REGISTRATION_TIE_SHARE, MIEN_REGISTRATION_TIE_DEVIATION_MM.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (no such field, or it is not known of this registration)</exception>
        /// <remarks>C: mien_registration_get_field()</remarks>
        public double[] GetField(RegistrationKind field)
        {
            using (var call = new Call())
            {
                var registrationAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_registration_get_field(registrationAt, (int)field, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows);
            }
        }

        /// <summary>The dense correspondence: for every template vertex the scan's triangle (or point, for a cloud) nearest to its
        /// fitted place, and barycentric coordinates in it. Numbers are those of the scan as it was given.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_registration_get_correspondence()</remarks>
        public RegistrationCorrespondence GetCorrespondence()
        {
            using (var call = new Call())
            {
                var registrationAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(3 * 8);
                IntPtr trianglesAt;
                IntPtr barycentricAt;
                do {
                    trianglesAt = call.Room(capacity * 4);
                    barycentricAt = call.Room(capacity * 3 * 8);
                } while ((capacity = call.More(Functions.mien_registration_get_correspondence(registrationAt, trianglesAt, barycentricAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return new RegistrationCorrespondence(call.ReadUints(trianglesAt, rows), call.ReadDoubles(barycentricAt, rows * 3));
            }
        }

        /// <summary>The motion from the template's frame to the scan's as a row-major 4 x 4 matrix.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_registration_get_motion()</remarks>
        public double[] GetMotion()
        {
            using (var call = new Call())
            {
                var registrationAt = call.Use(this);
                var matrixAt = call.Room(16 * 8);
                call.Check(Functions.mien_registration_get_motion(registrationAt, matrixAt, call.Error));
                return call.ReadDoubles(matrixAt, 16);
            }
        }

        /// <summary>Verdict with reasons, energies, motion, color_agreement (correlation of each feature's colour with the template,
        /// -1 to 1; empty when colours had no say), measures and expected_error of every zone and summaries as JSON text.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_registration_get_json()</remarks>
        public string GetJson()
        {
            using (var call = new Call())
            {
                var registrationAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_registration_get_json(registrationAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>Keeps a registration as a file: the fitted template, its residuals, weights and deviations, the verdict with its
        /// reasons and notes, the tie to another visit and the model's zones, so that visits can be registered today and
        /// studied in a year. The scan is not in it.</summary>
        /// <param name="path">UTF-8; replaced whole.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_registration_save()</remarks>
        public void Save(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var registrationAt = call.Use(this);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_registration_save(sessionAt, registrationAt, pathAt, call.Error));
            }
        }

        /// <summary>Reads a registration that mien_registration_save() kept. It gives the same bits as the registration itself.</summary>
        /// <param name="path">UTF-8.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_WRONG_KIND,
        /// MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_registration_load()</remarks>
        public static Registration Load(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_registration_load(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new Registration(call.Pointer(outAt)));
            }
        }

        /// <summary>A registration of a face that was fitted elsewhere, or whose arrays a host kept itself. What is not given here
        /// is zero or empty in it.</summary>
        /// <param name="mesh">the fitted template, mm.</param>
        /// <param name="quality">MIEN_QUALITY_*: the verdict on the fit.</param>
        /// <param name="weight">may be left out: not known; #V values, 0 to 1: how far the scan was seen there.</param>
        /// <param name="residual">may be left out: zero; #V values, mm: signed distance to the scan.</param>
        /// <param name="standardDeviation">may be left out: not known; #V values, mm, &gt;= 0: of the place, per axis.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (lengths), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_registration_create()</remarks>
        public static Registration Create(Session session, Mesh mesh, Quality quality, Values weight = null, Values residual = null, Values standardDeviation = null)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var meshAt = call.Use(mesh);
                var weightAt = call.ViewOrNull(weight, 1, "weight");
                var residualAt = call.ViewOrNull(residual, 1, "residual");
                var standardDeviationAt = call.ViewOrNull(standardDeviation, 1, "standard_deviation");
                var outAt = call.Room(8);
                call.Check(Functions.mien_registration_create(sessionAt, meshAt, weightAt, residualAt, standardDeviationAt, (int)quality, outAt, call.Error));
                return call.Keep(new Registration(call.Pointer(outAt)));
            }
        }

        /// <summary>Ties a later visit's registration to an earlier one's along the skin: its places slide along the scan until each
        /// lies on the freckles and pores that it lay on at the earlier visit, where both scans' pictures (a texture image,
        /// or colours at the vertices) show the same detail, and go on smoothly where they do not. Form, verdict and
        /// weights stay; residuals, correspondence and deviations are those of the moved places. When the pictures agree on
        /// too little (another person, plain skin, very unlike light) nothing moves: that is no error, and the JSON report
        /// says so under "reference", with why.</summary>
        /// <param name="model">which both registrations were made with.</param>
        /// <param name="referenceScan">the scan that it was made of, with colours.</param>
        /// <param name="registration">the later visit.</param>
        /// <param name="scan">the scan that it was made of, with colours.</param>
        /// <param name="options">may be left out: the defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (options; a scan without colours), MIEN_E_UNSUPPORTED_OPTION,
        /// MIEN_E_MISMATCH (a fit of another template; a scan that does not lie under its fit), MIEN_E_INVALID_MESH,
        /// MIEN_E_CANCELLED, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_registration_tie()</remarks>
        public Registration Tie(Session session, Model model, Mesh referenceScan, Registration registration, Mesh scan, TieOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(model);
                var referenceAt = call.Use(this);
                var referenceScanAt = call.Use(referenceScan);
                var registrationAt = call.Use(registration);
                var scanAt = call.Use(scan);
                var optionsAt = (options ?? new TieOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_registration_tie(sessionAt, modelAt, referenceAt, referenceScanAt, registrationAt, scanAt, optionsAt, outAt, call.Error));
                return call.Keep(new Registration(call.Pointer(outAt)));
            }
        }

        /// <summary>Ties a later visit's registration to an earlier one's along the skin: its places slide along the scan until each
        /// lies on the freckles and pores that it lay on at the earlier visit, where both scans' pictures (a texture image,
        /// or colours at the vertices) show the same detail, and go on smoothly where they do not. Form, verdict and
        /// weights stay; residuals, correspondence and deviations are those of the moved places. When the pictures agree on
        /// too little (another person, plain skin, very unlike light) nothing moves: that is no error, and the JSON report
        /// says so under "reference", with why.</summary>
        /// <param name="model">which both registrations were made with.</param>
        /// <param name="referenceScan">the scan that it was made of, with colours.</param>
        /// <param name="registration">the later visit.</param>
        /// <param name="scan">the scan that it was made of, with colours.</param>
        /// <param name="options">may be left out: the defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (options; a scan without colours), MIEN_E_UNSUPPORTED_OPTION,
        /// MIEN_E_MISMATCH (a fit of another template; a scan that does not lie under its fit), MIEN_E_INVALID_MESH,
        /// MIEN_E_CANCELLED, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_registration_tie()</remarks>
        public Task<Registration> TieAsync(Session session, Model model, Mesh referenceScan, Registration registration, Mesh scan, TieOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Tie(session, model, referenceScan, registration, scan, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>The coefficients of a registered face: its fitted template, brought back into the model's frame by the
        /// registration's own motion and fitted as by mien_model_fit(). What the fit took from the model comes back; what
        /// it moved beyond the model's span, to close the last gap to the scan, is left out.</summary>
        /// <param name="ridgeMm2">mm^2, &gt;= 0; 0: the nearest face of the model's span.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (of another model), MIEN_E_NO_SOLUTION,
        /// MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_registration_get_coefficients()</remarks>
        public double[] GetCoefficients(Session session, Model model, double ridgeMm2)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var registrationAt = call.Use(this);
                var modelAt = call.Use(model);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_registration_get_coefficients(sessionAt, registrationAt, modelAt, ridgeMm2, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows);
            }
        }
    }
}
