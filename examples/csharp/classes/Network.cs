// Written by abi/generate_bindings.py; how classes work stands in Runtime.cs.
using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Mien.Native;

namespace Mien
{
    /// <summary>A trained network with everything that belongs to it: layers, weights, neighbour lists and statistics of one
    /// template. It may be one network, or two over the low and the high frequencies of a face, joined by spectral
    /// assembly; the code of the latter holds first the low band's numbers, then the high band's. Immutable: share
    /// freely.</summary>
    public sealed unsafe class Network : NativeObject
    {
        internal Network(IntPtr owned) : base(owned, at => Functions.mien_network_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public Network Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_network_retain(at);
                return new Network(at);
            }
        }

        /// <summary>Loads a network file through a memory map and checks all of it: structure, hash, finite weights, every index of
        /// every list. A file is treated as hostile.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_WRONG_KIND,
        /// MIEN_E_UNSUPPORTED_VERSION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_network_load()</remarks>
        public static Network Load(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_network_load(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new Network(call.Pointer(outAt)));
            }
        }

        /// <summary>Loads a network from the bytes of a network file that the host holds in memory, e.g. as a resource of its
        /// program. The bytes are copied.</summary>
        /// <param name="data">size bytes.</param>
        /// <exception cref="MienException">as mien_network_load(), without MIEN_E_IO</exception>
        /// <remarks>C: mien_network_load_memory()</remarks>
        public static Network LoadMemory(Session session, byte[] data)
        {
            using (var call = new Call())
            {
                call.Required(data, "data");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var size = call.Rows(data, 1, "data");
                var dataAt = call.Array(data);
                var outAt = call.Room(8);
                call.Check(Functions.mien_network_load_memory(sessionAt, dataAt, (ulong)size, outAt, call.Error));
                return call.Keep(new Network(call.Pointer(outAt)));
            }
        }

        /// <summary>Numbers of vertices of the faces and of numbers in a code.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_network_get_counts()</remarks>
        public NetworkCounts GetCounts()
        {
            using (var call = new Call())
            {
                var networkAt = call.Use(this);
                var vertexCountAt = call.Room(8);
                var codeCountAt = call.Room(8);
                call.Check(Functions.mien_network_get_counts(networkAt, vertexCountAt, codeCountAt, call.Error));
                return new NetworkCounts(*(ulong*)vertexCountAt, *(ulong*)codeCountAt);
            }
        }

        /// <summary>What the network is, as JSON: name, sizes, features, layers with their multiply-adds, and what its training
        /// wrote down.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_network_get_json()</remarks>
        public string GetJson()
        {
            using (var call = new Call())
            {
                var networkAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_network_get_json(networkAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>The mean face of the network's training, in whose frame codes are decoded.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_network_get_mean()</remarks>
        public Mesh GetMean()
        {
            using (var call = new Call())
            {
                var networkAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_network_get_mean(networkAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>The code of a face. With dst null and capacity 0: writes the count only.</summary>
        /// <param name="face">#V vertices in the network's topology, mm, anywhere.</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (no encoder), MIEN_E_MISMATCH (vertex
        /// count), MIEN_E_INVALID_MESH (not finite), MIEN_E_NO_SOLUTION (no rigid motion; a result that is not finite),
        /// MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_network_encode()</remarks>
        public NetworkEncode Encode(Session session, Mesh face, NetworkOptions options = null)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var networkAt = call.Use(this);
                var faceAt = call.Use(face);
                var optionsAt = call.Record(options, sizeof(Native.NetworkOptions), true, "options");
                var motionAt = call.Room(12 * 8);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_network_encode(sessionAt, networkAt, faceAt, optionsAt, motionAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return new NetworkEncode(call.ReadDoubles(motionAt, 12), call.ReadDoubles(dstAt, rows));
            }
        }

        /// <summary>The face of a code.</summary>
        /// <param name="code">code_count finite values.</param>
        /// <param name="motion">may be left out: the mean's frame; 12 float64 of mien_network_encode(), which is undone.</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (not finite, motion not rigid), MIEN_E_UNSUPPORTED_OPTION (no
        /// decoder; a network that adds an expression), MIEN_E_MISMATCH (code_count), MIEN_E_NO_SOLUTION (a result that is
        /// not finite), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_network_decode()</remarks>
        public Mesh Decode(Session session, double[] code, double[] motion = null, NetworkOptions options = null)
        {
            using (var call = new Call())
            {
                call.Required(code, "code");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var networkAt = call.Use(this);
                var codeCount = call.Rows(code, 1, "code");
                var codeAt = call.Array(code);
                call.Agree("motion", call.Rows(motion, 1, "motion"), 12);
                var motionAt = call.Array(motion);
                var optionsAt = call.Record(options, sizeof(Native.NetworkOptions), true, "options");
                var outAt = call.Room(8);
                call.Check(Functions.mien_network_decode(sessionAt, networkAt, codeAt, (ulong)codeCount, motionAt, optionsAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>The decoded face of a face's code, in the frame of that face: an autoencoder's reconstruction, or what the
        /// network was trained to make of a face (a neutral one into an expression, with what is the person's own kept).
        /// Networks on deformations, which know no place, have their result put onto the face rigidly; one that deforms a
        /// neutral face alone keeps that one's centre.</summary>
        /// <param name="face">#V vertices in the network's topology, mm, anywhere.</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a half is missing), MIEN_E_MISMATCH
        /// (vertex count), MIEN_E_INVALID_MESH (not finite), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_network_apply()</remarks>
        public Mesh Apply(Session session, Mesh face, NetworkOptions options = null)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var networkAt = call.Use(this);
                var faceAt = call.Use(face);
                var optionsAt = call.Record(options, sizeof(Native.NetworkOptions), true, "options");
                var outAt = call.Room(8);
                call.Check(Functions.mien_network_apply(sessionAt, networkAt, faceAt, optionsAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Which numbers of a code belong to which band. Editing some of them changes that band of the decoded face (and
        /// the other one as far as its decoder was conditioned).</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_network_get_bands()</remarks>
        public NetworkBands GetBands()
        {
            using (var call = new Call())
            {
                var networkAt = call.Use(this);
                var lowCodeCountAt = call.Room(8);
                var bandLimitAt = call.Room(8);
                call.Check(Functions.mien_network_get_bands(networkAt, lowCodeCountAt, bandLimitAt, call.Error));
                return new NetworkBands(*(ulong*)lowCodeCountAt, *(long*)bandLimitAt);
            }
        }

        /// <summary>A face between two, or with the bands of both: each band's code goes from a's to b's by its own weight and is
        /// decoded. Weights 0 and 0 give a as the network gives it back, 1 and 0 or 0 and 1 exchange a band, equal ones
        /// interpolate. A network without bands takes the first weight.</summary>
        /// <param name="a">#V vertices in the network's topology, mm, anywhere.</param>
        /// <param name="b">#V vertices in the network's topology, mm, anywhere.</param>
        /// <param name="lowWeight">of the low band; any finite number.</param>
        /// <param name="highWeight">of the high band; any finite number.</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (a weight that is not finite), MIEN_E_UNSUPPORTED_OPTION (a half
        /// is missing; a network that adds an expression), MIEN_E_MISMATCH (vertex count), MIEN_E_INVALID_MESH (not
        /// finite), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_network_mix()</remarks>
        public Mesh Mix(Session session, Mesh a, Mesh b, double lowWeight, double highWeight, NetworkOptions options = null)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var networkAt = call.Use(this);
                var aAt = call.Use(a);
                var bAt = call.Use(b);
                var optionsAt = call.Record(options, sizeof(Native.NetworkOptions), true, "options");
                var outAt = call.Room(8);
                call.Check(Functions.mien_network_mix(sessionAt, networkAt, aAt, bAt, lowWeight, highWeight, optionsAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>The code of a made-up face: drawn from a Gaussian over the codes of the training faces, which the file holds.
        /// Number and seed alone decide. With dst null and capacity 0: writes the count only.</summary>
        /// <param name="seed">of the chance.</param>
        /// <param name="number">of the code within the seed's series.</param>
        /// <param name="spread">0 the mean code, 1 as far apart as the training faces; not negative.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (spread), MIEN_E_UNSUPPORTED_OPTION (no distribution in the
        /// file), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_network_sample()</remarks>
        public double[] Sample(ulong seed, ulong number, double spread)
        {
            using (var call = new Call())
            {
                var networkAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_network_sample(networkAt, seed, number, spread, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows);
            }
        }

        /// <summary>How well the network gives back the faces of a dataset, as JSON: l1_mm, l2_mm, dame and fmpd as means over the
        /// faces and by face. Judge a network on people that it was not trained on.</summary>
        /// <param name="datasetPath">a dataset file in the network's topology.</param>
        /// <param name="options">may be left out: all faces.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a half is missing, a switch, a
        /// network that adds an expression), MIEN_E_MISMATCH (vertex count), MIEN_E_NOT_FOUND (no such face), MIEN_E_IO,
        /// MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_network_evaluate()</remarks>
        public string Evaluate(Session session, string datasetPath, NetworkEvaluationOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var networkAt = call.Use(this);
                var datasetPathAt = call.Text(datasetPath);
                var optionsAt = (options ?? new NetworkEvaluationOptions()).Write(call, progress, cancellationToken);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_network_evaluate(sessionAt, networkAt, datasetPathAt, optionsAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>How well the network gives back the faces of a dataset, as JSON: l1_mm, l2_mm, dame and fmpd as means over the
        /// faces and by face. Judge a network on people that it was not trained on.</summary>
        /// <param name="datasetPath">a dataset file in the network's topology.</param>
        /// <param name="options">may be left out: all faces.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a half is missing, a switch, a
        /// network that adds an expression), MIEN_E_MISMATCH (vertex count), MIEN_E_NOT_FOUND (no such face), MIEN_E_IO,
        /// MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_network_evaluate()</remarks>
        public Task<string> EvaluateAsync(Session session, string datasetPath, NetworkEvaluationOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Evaluate(session, datasetPath, options, progress, cancellationToken), cancellationToken);
        }
    }
}
