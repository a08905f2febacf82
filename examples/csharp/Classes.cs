// Classes over the C interface: one per handle, struct and group of constants.
// Written by abi/generate_bindings.py; how they work stands in Runtime.cs.
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

    /// <summary>Stages of long work, as a progress callback sees them.</summary>
    public enum Stage
    {
        Reading = 1,
        Geodesics = 2,
        Basis = 3,
        Alignment = 4,
        Fitting = 5,
        Refining = 6,
        Training = 7,
        Neutralizing = 8,
        Measuring = 9,
        Writing = 10,
    }

    /// <summary>MIEN_LOG_* of the C interface.</summary>
    public enum Log
    {
        Error = 1,
        Warning = 2,
        Info = 3,
        Debug = 4,
    }

    /// <summary>MIEN_DTYPE_* of the C interface.</summary>
    public enum Dtype
    {
        F32 = 1,
        F64 = 2,
        I32 = 3,
        U32 = 4,
        U8 = 5,
    }

    /// <summary>Kernels: what makes two vertices of the template move alike.</summary>
    public enum KernelKind
    {
        /// <summary>no kernel: modes from faces alone (needs pca_dataset)</summary>
        None = 0,
        /// <summary>squared exponential of the straight distance</summary>
        EuclideanSe = 1,
        /// <summary>of the distance along the surface: mouth and eyes may open</summary>
        GeodesicSe = 2,
        /// <summary>cubic B-splines on a grid in space</summary>
        Bspline = 3,
        /// <summary>Matern along the surface, positive definite by construction</summary>
        SurfaceMatern = 4,
    }

    /// <summary>What the heat of the heat method does at borders of the template.</summary>
    public enum Heat
    {
        /// <summary>stays inside</summary>
        Neumann = 1,
        /// <summary>is cooled to zero</summary>
        Dirichlet = 2,
        /// <summary>half of each</summary>
        Average = 3,
    }

    /// <summary>What is known of a landmark.</summary>
    public enum Mark
    {
        /// <summary>null, not a number, "not defined" or a placeholder in its file</summary>
        NotPicked = 0,
        Place = 1,
        Vertex = 2,
    }

    /// <summary>Kinds of measurements.</summary>
    public enum Measure
    {
        /// <summary>straight, mm</summary>
        Length = 1,
        /// <summary>along the skin, mm</summary>
        SurfaceLength = 2,
        /// <summary>degrees</summary>
        Angle = 3,
        /// <summary>signed, of one line against another, degrees</summary>
        Inclination = 4,
        /// <summary>percent</summary>
        Proportion = 5,
        /// <summary>signed distance from a line, mm</summary>
        LineOffset = 6,
    }

    /// <summary>Places of the whole face and of what no zone covers, beside 0 .. zone_count - 1.</summary>
    public enum ZoneKind
    {
        Whole = -1,
        Rest = -2,
    }

    /// <summary>Fields with one value per vertex of the before face.</summary>
    public enum Field
    {
        /// <summary>along the normal of the before face</summary>
        SignedDistanceMm = 1,
        /// <summary>length of the displacement or to the closest place</summary>
        DistanceMm = 2,
        PositiveVolumeMm3 = 3,
        NegativeVolumeMm3 = 4,
        /// <summary>1/mm, positive where the surface bulges outwards</summary>
        CurvatureMaximal = 5,
        /// <summary>1/mm</summary>
        CurvatureMinimal = 6,
        /// <summary>1/mm</summary>
        CurvatureMean = 7,
        /// <summary>1/mm^2</summary>
        CurvatureGaussian = 8,
    }

    /// <summary>How vertices are carried onto a surface that is not in correspondence.</summary>
    public enum Carry
    {
        ClosestPoint = 1,
        /// <summary>along one direction: a height field's integral</summary>
        Direction = 2,
        VertexNormal = 3,
    }

    /// <summary>What the mirror plane of a face is found by.</summary>
    public enum MirrorBy
    {
        /// <summary>all vertices and their partners, robustly</summary>
        Surface = 0,
        /// <summary>the landmarks and their partners alone</summary>
        Landmarks = 1,
    }

    /// <summary>Mass matrices of the Laplacian.</summary>
    public enum Mass
    {
        MixedVoronoi = 0,
        Barycentric = 1,
        /// <summary>bands then follow the triangulation's density; for comparison</summary>
        None = 2,
    }

    /// <summary>What to do with negative cotangent weights.</summary>
    public enum Cotangents
    {
        IntrinsicDelaunay = 0,
        Clamp = 1,
        Keep = 2,
    }

    /// <summary>Distances between two faces.</summary>
    public enum Metric
    {
        /// <summary>mm: mean of |dx| + |dy| + |dz| over the vertices</summary>
        L1 = 1,
        /// <summary>mm: mean Euclidean distance over the vertices</summary>
        L2 = 2,
        /// <summary>mm: largest distance of a vertex from the other surface, both ways</summary>
        Hausdorff = 3,
        /// <summary>rad: change of the dihedral angles, masked, weighted with area</summary>
        Dame = 4,
        /// <summary>0 to 1: difference of the global roughness</summary>
        Fmpd = 5,
    }

    /// <summary>How the number of deformation modes grows over the rounds (jousse-2022 2.5.2.2).</summary>
    public enum Growth
    {
        Constant = 0,
        Linear = 1,
        Exponential = 2,
        Cubic = 3,
    }

    /// <summary>Where a fit begins.</summary>
    public enum Start
    {
        /// <summary>landmarks when three match, else a search</summary>
        Automatic = 0,
        Landmarks = 1,
        /// <summary>start_rotation, start_translation, start_scale</summary>
        Pose = 2,
        /// <summary>over all poses, those up to 60 degrees off frontal first</summary>
        Search = 3,
    }

    /// <summary>What one unit of the scan is.</summary>
    public enum Units
    {
        /// <summary>metres, deci- and centimetres and inches are recognised by size and scaled</summary>
        Detect = 0,
        Millimetres = 1,
        /// <summary>anything that does not look like millimetres is an error</summary>
        Refuse = 2,
    }

    /// <summary>What is done about landmarks whose left and right are exchanged.</summary>
    public enum Sides
    {
        /// <summary>MIEN_E_MISMATCH that names them</summary>
        Refuse = 0,
        /// <summary>exchange them back and say so in the report</summary>
        Mend = 1,
        Ignore = 2,
    }

    /// <summary>How far a fit is to be trusted.</summary>
    public enum Quality
    {
        Good = 0,
        Doubtful = 1,
        Failed = 2,
    }

    /// <summary>Fields with one value per template vertex.</summary>
    public enum RegistrationKind
    {
        /// <summary>signed distance to the scan, positive: the scan lies outside</summary>
        ResidualMm = 1,
        /// <summary>in [0, 1]: how much of the scan's say counted</summary>
        Weight = 2,
        /// <summary>of the place, per axis (root mean square)</summary>
        StandardDeviationMm = 3,
        /// <summary>the true place lies within, 95 times out of 100: the deviation's pattern in the size of the zone's expected
        /// error (mien_registration_get_expected_error)</summary>
        Radius95Mm = 4,
        /// <summary>how far the surface may lie off the skin along its normal: what mien_measure_options wants. Since 0.2</summary>
        NormalDeviationMm = 5,
    }

    /// <summary>What mien_surface_transfer_json() carries over.</summary>
    public enum Transfer
    {
        Landmarks = 1,
        Zones = 2,
    }

    /// <summary>How a face is taken apart into identity and expression.</summary>
    public enum Fit
    {
        /// <summary>prior of one of a few expressions; the default and the best</summary>
        Mixture = 0,
        /// <summary>Gaussian priors</summary>
        Map = 1,
        /// <summary>joint least squares without a prior</summary>
        Exact = 2,
        /// <summary>block relaxation, for reproduction</summary>
        Alternating = 3,
    }

    /// <summary>Where a face lies against the training faces.</summary>
    public enum Pose
    {
        /// <summary>on the model's stable zone where it has one; else rigid when the face lies more than 3 degrees or 8 mm away from
        /// the mean face and a rigid motion explains it clearly better, else kept</summary>
        Auto = 0,
        /// <summary>in the training's frame</summary>
        Keep = 1,
        /// <summary>anywhere: a rigid motion is fitted together with the face</summary>
        Rigid = 2,
    }

    /// <summary>How a treated zone is read.</summary>
    public enum Reading
    {
        /// <summary>the zone is no witness: what the result holds</summary>
        Treated = 0,
        /// <summary>all of the face is a witness</summary>
        AsExpression = 1,
    }

    /// <summary>Directions of a hierarchy's maps.</summary>
    public enum MapKind
    {
        /// <summary>from the next finer level to this one</summary>
        Down = 1,
        /// <summary>from this level to the next finer one</summary>
        Up = 2,
    }

    /// <summary>Representations.</summary>
    public enum Features
    {
        Euclidean = 1,
        EuclideanStandardised = 2,
        EuclideanNormalised = 3,
        Deformation = 4,
        DeformationNormalised = 5,
        DeformationStandardised = 6,
    }

    /// <summary>Which algorithm finds the latent variables; with one score both give the same regression.</summary>
    public enum Pls
    {
        Nipals = 0,
        Simpls = 1,
    }

    /// <summary>What each vertex gives. jousse-2022 (B.2) has 17 numbers a vertex without naming them; ours are displacement
    /// (3), change of the normal (3), k1, k2, mean and Gaussian curvature, curvedness, and the curvature tensor (6),
    /// each of them an equal part of curvature_share.</summary>
    public enum ScoreFeatures
    {
        /// <summary>displacement, k1, k2</summary>
        DisplacementAndCurvature = 0,
        /// <summary>all 17</summary>
        All = 1,
    }

    /// <summary>Why a change has no deviation.</summary>
    public enum StudyKind
    {
        Known = 0,
        /// <summary>too little of the zone was seen: no values either</summary>
        Unseen = 1,
        /// <summary>the fit of one of the visits failed</summary>
        FailedFit = 2,
        /// <summary>a face came without deviations</summary>
        NoSurfaceErrors = 3,
        /// <summary>the zone lies behind the expression model's rim</summary>
        OutsideExpressions = 4,
    }

    /// <summary>Fields with one value per vertex of a visit's face.</summary>
    public enum StudyField
    {
        /// <summary>how far the fitted surface may lie off the skin</summary>
        NormalSdMm = 1,
        /// <summary>in [0, 1]: how far the scan was seen there</summary>
        Weight = 2,
        /// <summary>of the expression that was taken off: root of the summed posterior variance of a place's coordinates</summary>
        ExpressionSdMm = 3,
    }

    /// <summary>How the two subspaces are found.</summary>
    public enum Train
    {
        /// <summary>joint PCA</summary>
        Jpca = 0,
        /// <summary>quasi-orthogonal joint PCA</summary>
        Qojpca = 1,
    }

    /// <summary>mien_session_options of the C interface.</summary>
    public sealed unsafe class SessionOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public SessionOptions()
        {
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

    /// <summary>A named set of vertices of a surface, read in place and only during the call.</summary>
    public sealed unsafe class Zone : Record
    {
        public string Name { get; set; }
        /// <summary>vertex_count vertex numbers, repeated ones count once</summary>
        public uint[] Vertices { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.Zone*)at;
            raw->name = call.Text(Name);
            call.Required(Vertices, "vertices");
            raw->vertices = call.Array(Vertices);
            raw->vertexCount = (ulong)call.Rows(Vertices, 1, "vertices");
        }
    }

    /// <summary>A texture image of the host's, read in place and only during the call: either pixels or the bytes of a file.</summary>
    public sealed unsafe class Image : Record
    {
        /// <summary>UTF-8 file name without a folder; may be left out</summary>
        public string Name { get; set; }
        /// <summary>height rows of width x 3 red green blue, from the top; may be left out</summary>
        public byte[] Pixels { get; set; }
        /// <summary>from row to row; 0: tightly packed</summary>
        public ulong RowStrideBytes { get; set; }
        /// <summary>of pixels, else 0</summary>
        public uint Width { get; set; }
        /// <summary>of pixels, else 0</summary>
        public uint Height { get; set; }
        /// <summary>the bytes of a JPEG or PNG file; may be left out: when pixels are given</summary>
        public byte[] File { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.Image*)at;
            raw->rowStrideBytes = RowStrideBytes;
            raw->width = Width;
            raw->height = Height;
            raw->name = call.TextOrNull(Name);
            raw->pixels = call.Array(Pixels);
            if (Pixels != null) call.Agree("pixels", call.Rows(Pixels, (long)raw->width * 3, "pixels"), (long)raw->height);
            raw->file = call.Array(File);
            raw->fileSize = (ulong)call.Rows(File, 1, "file");
        }
    }

    /// <summary>A material of a mesh, read in place and only during the call.</summary>
    public sealed unsafe class Material : Record
    {
        /// <summary>UTF-8; may be left out</summary>
        public string Name { get; set; }
        /// <summary>number of the base colour's image, -1: none</summary>
        public int Image { get; set; }
        /// <summary>0 to 1; an image is times this</summary>
        public double Red { get; set; }
        public double Green { get; set; }
        public double Blue { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.Material*)at;
            raw->image = Image;
            raw->red = Red;
            raw->green = Green;
            raw->blue = Blue;
            raw->name = call.TextOrNull(Name);
        }
    }

    /// <summary>What a mesh is made of.</summary>
    public sealed unsafe class MeshArrays : Record
    {
        /// <summary>#V x 3, F32 or F64, mm</summary>
        public Values Positions { get; set; }
        /// <summary>#F x 3 tightly packed, counter-clockwise seen from outside; may be left out</summary>
        public uint[] Triangles { get; set; }
        /// <summary>#V x 3 red green blue, tightly packed; may be left out</summary>
        public byte[] Colors { get; set; }
        /// <summary>#T x 2, (0, 0) at the image's lower left corner; may be left out</summary>
        public float[] Texture { get; set; }
        /// <summary>#F x 3 numbers of texture; may be left out: with texture, texture has a row for each vertex</summary>
        public uint[] TextureTriangles { get; set; }
        /// <summary>may be left out</summary>
        public IReadOnlyList<Material> Materials { get; set; }
        /// <summary>#F numbers of materials; null: all are of the first</summary>
        public uint[] TriangleMaterials { get; set; }
        /// <summary>may be left out</summary>
        public IReadOnlyList<Image> Images { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.MeshArrays*)at;
            Functions.mien_mesh_arrays_init(at, (UIntPtr)sizeof(Native.MeshArrays));
            raw->positions = call.Matrix(Positions, 3, "positions");
            raw->triangles = call.Array(Triangles);
            raw->triangleCount = (ulong)call.Rows(Triangles, 3, "triangles");
            raw->colors = call.Array(Colors);
            if (Colors != null) call.Agree("colors", call.Rows(Colors, 3, "colors"), (long)raw->positions.count);
            raw->texture = call.Array(Texture);
            raw->textureCount = (ulong)call.Rows(Texture, 2, "texture");
            raw->textureTriangles = call.Array(TextureTriangles);
            if (TextureTriangles != null) call.Agree("texture_triangles", call.Rows(TextureTriangles, 3, "texture_triangles"), (long)raw->triangleCount);
            raw->materials = call.Records(Materials, sizeof(Native.Material));
            raw->materialCount = (ulong)call.Rows(Materials, 1, "materials");
            raw->triangleMaterials = call.Array(TriangleMaterials);
            if (TriangleMaterials != null) call.Agree("triangle_materials", call.Rows(TriangleMaterials, 1, "triangle_materials"), (long)raw->triangleCount);
            raw->images = call.Records(Images, sizeof(Native.Image));
            raw->imageCount = (ulong)call.Rows(Images, 1, "images");
        }
    }

    /// <summary>One more kernel of a sum.</summary>
    public sealed unsafe class Kernel : Record
    {
        /// <summary>MIEN_KERNEL_..., not NONE</summary>
        public KernelKind Kind { get; set; }
        public double SigmaMm { get; set; }
        public double ScaleMm { get; set; }
        /// <summary>read for SURFACE_MATERN only</summary>
        public double Nu { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.Kernel*)at;
            raw->kind = (int)Kind;
            raw->sigmaMm = SigmaMm;
            raw->scaleMm = ScaleMm;
            raw->nu = Nu;
        }

        internal static Kernel Read(Call call, IntPtr at)
        {
            var raw = (Native.Kernel*)at;
            var made = new Kernel();
            made.Kind = (KernelKind)raw->kind;
            made.SigmaMm = raw->sigmaMm;
            made.ScaleMm = raw->scaleMm;
            made.Nu = raw->nu;
            return made;
        }
    }

    /// <summary>A named vertex of the template.</summary>
    public sealed unsafe class Landmark : Record
    {
        public string Name { get; set; }
        public uint Vertex { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.Landmark*)at;
            raw->vertex = Vertex;
            raw->name = call.Text(Name);
        }
    }

    /// <summary>Where a landmark was seen.</summary>
    public sealed unsafe class LandmarkObservation : Record
    {
        /// <summary>of a landmark of the model; null: `vertex` says which</summary>
        public string Name { get; set; }
        /// <summary>read when name is null</summary>
        public uint Vertex { get; set; }
        /// <summary>mm, in the frame of the template</summary>
        public double[] Position { get; set; }
        /// <summary>standard deviation of each coordinate, &gt;= 0.000001</summary>
        public double NoiseMm { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.LandmarkObservation*)at;
            raw->vertex = Vertex;
            raw->noiseMm = NoiseMm;
            raw->name = call.TextOrNull(Name);
            Call.CopyIn(Position, raw->position, 3, "position");
        }
    }

    /// <summary>mien_model_options of the C interface.</summary>
    public sealed unsafe class ModelOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public ModelOptions()
        {
            var raw = default(Native.ModelOptions);
            Functions.mien_model_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.ModelOptions));
            Kernel = (KernelKind)raw.kernel;
            SigmaMm = raw.sigmaMm;
            ScaleMm = raw.scaleMm;
            Nu = raw.nu;
            Levels = raw.levels;
            NumModes = raw.numModes;
            Tolerance = raw.tolerance;
            NumControlPoints = raw.numControlPoints;
            MirrorSymmetric = raw.mirrorSymmetric;
            MirrorCorrelation = raw.mirrorCorrelation;
            EigenvalueThreshold = raw.eigenvalueThreshold;
            HeatTimeFactor = raw.heatTimeFactor;
            HeatBoundary = (Heat)raw.heatBoundary;
            PcaModes = raw.pcaModes;
            PcaVariance = raw.pcaVariance;
            PcaAllExpressions = raw.pcaAllExpressions;
            PcaAlign = raw.pcaAlign;
        }

        /// <summary>MIEN_KERNEL_..., default GEODESIC_SE</summary>
        public KernelKind Kernel { get; set; }
        /// <summary>length scale; full width for BSPLINE; &gt; 0, default 20</summary>
        public double SigmaMm { get; set; }
        /// <summary>standard deviation of a displacement's coordinate; &gt; 0, default 3</summary>
        public double ScaleMm { get; set; }
        /// <summary>smoothness of SURFACE_MATERN, 0.1 to 20, default 2</summary>
        public double Nu { get; set; }
        /// <summary>1 to 12, default 1: sum of kernels with sigma, 2 sigma, 4 sigma, ...</summary>
        public int Levels { get; set; }
        /// <summary>deformation modes at most, 3 per scalar mode; &gt;= 3, default 999</summary>
        public int NumModes { get; set; }
        /// <summary>kernel_count kernels added to the one above; may be left out</summary>
        public IReadOnlyList<Kernel> Kernels { get; set; }
        /// <summary>&gt; 0: stop once this share of the variance is left; default 0</summary>
        public double Tolerance { get; set; }
        /// <summary>default 0: max(1000, num_modes), never more than #V</summary>
        public int NumControlPoints { get; set; }
        /// <summary>1: modes purely even or odd about the plane x = 0; default 0</summary>
        public int MirrorSymmetric { get; set; }
        /// <summary>0 to 1: how much both sides are expected to move alike; default 0</summary>
        public double MirrorCorrelation { get; set; }
        /// <summary>eigenvalues among the control points below this share of the largest are dropped; 0 &lt; x &lt; 1, default
        /// 0.0001</summary>
        public double EigenvalueThreshold { get; set; }
        /// <summary>heat time in units of (mean edge)^2, 0.01 to 10000, default 4</summary>
        public double HeatTimeFactor { get; set; }
        /// <summary>MIEN_HEAT_..., default NEUMANN</summary>
        public Heat HeatBoundary { get; set; }
        /// <summary>default 0: as many as pca_variance asks for</summary>
        public int PcaModes { get; set; }
        /// <summary>UTF-8 path of a dataset of registered faces, or null: adds their mean and principal modes; the kernel then
        /// stands for what they leave over</summary>
        public string PcaDataset { get; set; }
        /// <summary>share of the faces' variance kept, 0 to 1, default 0.999</summary>
        public double PcaVariance { get; set; }
        /// <summary>1 (default): all faces, 0: neutral ones</summary>
        public int PcaAllExpressions { get; set; }
        /// <summary>1: move each face rigidly onto the template first; default 0</summary>
        public int PcaAlign { get; set; }
        /// <summary>#V x 1 factors &gt;= 0 of scale_mm; count 0: one everywhere</summary>
        public Values ScalePerVertex { get; set; }
        /// <summary>landmark_count; may be left out</summary>
        public IReadOnlyList<Landmark> Landmarks { get; set; }
        /// <summary>zone_count; may be left out</summary>
        public IReadOnlyList<Zone> Zones { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.ModelOptions*)at;
            Functions.mien_model_options_init(at, (UIntPtr)sizeof(Native.ModelOptions));
            raw->kernel = (int)Kernel;
            raw->sigmaMm = SigmaMm;
            raw->scaleMm = ScaleMm;
            raw->nu = Nu;
            raw->levels = Levels;
            raw->numModes = NumModes;
            raw->tolerance = Tolerance;
            raw->numControlPoints = NumControlPoints;
            raw->mirrorSymmetric = MirrorSymmetric;
            raw->mirrorCorrelation = MirrorCorrelation;
            raw->eigenvalueThreshold = EigenvalueThreshold;
            raw->heatTimeFactor = HeatTimeFactor;
            raw->heatBoundary = (int)HeatBoundary;
            raw->pcaModes = PcaModes;
            raw->pcaVariance = PcaVariance;
            raw->pcaAllExpressions = PcaAllExpressions;
            raw->pcaAlign = PcaAlign;
            raw->scalePerVertex = call.Matrix(ScalePerVertex, 1, "scale_per_vertex");
            raw->kernels = call.Records(Kernels, sizeof(Native.Kernel));
            raw->kernelCount = (ulong)call.Rows(Kernels, 1, "kernels");
            raw->pcaDataset = call.TextOrNull(PcaDataset);
            raw->landmarks = call.Records(Landmarks, sizeof(Native.Landmark));
            raw->landmarkCount = (ulong)call.Rows(Landmarks, 1, "landmarks");
            raw->zones = call.Records(Zones, sizeof(Native.Zone));
            raw->zoneCount = (ulong)call.Rows(Zones, 1, "zones");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.ModelOptions));
            Fill(call, at);
            var raw = (Native.ModelOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }

    /// <summary>mien_tune_options of the C interface.</summary>
    public sealed unsafe class TuneOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public TuneOptions()
        {
            var raw = default(Native.TuneOptions);
            Functions.mien_tune_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.TuneOptions));
            Kernel = (KernelKind)raw.kernel;
            ScaleMm = raw.scaleMm;
            Nu = raw.nu;
            Rho = raw.rho;
            Levels = raw.levels;
            NumModes = raw.numModes;
            MaxSubjects = raw.maxSubjects;
        }

        /// <summary>MIEN_KERNEL_..., not NONE; default GEODESIC_SE</summary>
        public KernelKind Kernel { get; set; }
        /// <summary>sigma_count length scales to try, each &gt; 0</summary>
        public double[] SigmasMm { get; set; }
        /// <summary>&gt; 0, default 1</summary>
        public double ScaleMm { get; set; }
        /// <summary>default 2</summary>
        public double Nu { get; set; }
        /// <summary>weight of the prior in the fits, &gt;= 0, default 5</summary>
        public double Rho { get; set; }
        /// <summary>1 to 12, default 1</summary>
        public int Levels { get; set; }
        /// <summary>deformation modes, &gt;= 3, default 999</summary>
        public int NumModes { get; set; }
        /// <summary>expression_count names: these faces only; null: all</summary>
        public IReadOnlyList<string> Expressions { get; set; }
        /// <summary>of the dataset's order; 0 (default): all</summary>
        public int MaxSubjects { get; set; }
        /// <summary>scale_count scales to try with each sigma, each &gt; 0; null: scale_mm alone</summary>
        public double[] ScalesMm { get; set; }
        /// <summary>level_count numbers of levels to try with each of those, each 1 to 12; null: `levels` alone</summary>
        public int[] LevelCounts { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.TuneOptions*)at;
            Functions.mien_tune_options_init(at, (UIntPtr)sizeof(Native.TuneOptions));
            raw->kernel = (int)Kernel;
            raw->scaleMm = ScaleMm;
            raw->nu = Nu;
            raw->rho = Rho;
            raw->levels = Levels;
            raw->numModes = NumModes;
            raw->maxSubjects = MaxSubjects;
            call.Required(SigmasMm, "sigmas_mm");
            raw->sigmasMm = call.Array(SigmasMm);
            raw->sigmaCount = (ulong)call.Rows(SigmasMm, 1, "sigmas_mm");
            raw->expressions = call.Texts(Expressions);
            raw->expressionCount = (uint)call.Rows(Expressions, 1, "expressions");
            raw->scalesMm = call.Array(ScalesMm);
            raw->scaleCount = (ulong)call.Rows(ScalesMm, 1, "scales_mm");
            raw->levelCounts = call.Array(LevelCounts);
            raw->levelCount = (ulong)call.Rows(LevelCounts, 1, "level_counts");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.TuneOptions));
            Fill(call, at);
            var raw = (Native.TuneOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }

    /// <summary>A named place on a scan, read in place and only during the call.</summary>
    public sealed unsafe class ScanLandmark : Record
    {
        /// <summary>matched with the names stored in the model</summary>
        public string Name { get; set; }
        /// <summary>in the scan's frame and unit</summary>
        public double[] Position { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.ScanLandmark*)at;
            raw->name = call.Text(Name);
            Call.CopyIn(Position, raw->position, 3, "position");
        }
    }

    /// <summary>mien_anthropometry_options of the C interface.</summary>
    public sealed unsafe class AnthropometryOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public AnthropometryOptions()
        {
            var raw = default(Native.AnthropometryOptions);
            Functions.mien_anthropometry_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.AnthropometryOptions));
            SlideCorrelationMm = raw.slideCorrelationMm;
            NormalCorrelationMm = raw.normalCorrelationMm;
        }

        /// <summary>#V, mm: deviation of each vertex' place per axis, as MIEN_REGISTRATION_STANDARD_DEVIATION_MM tells it; count 0:
        /// not known, and no deviation</summary>
        public Values PlaceSd { get; set; }
        /// <summary>#V, mm: along the normal, as MIEN_REGISTRATION_NORMAL_DEVIATION_MM tells it; count 0: as place_sd</summary>
        public Values NormalSd { get; set; }
        /// <summary>over which a template slides together along the skin; default 15</summary>
        public double SlideCorrelationMm { get; set; }
        /// <summary>over which it errs together across the skin; default 4</summary>
        public double NormalCorrelationMm { get; set; }
        /// <summary>may be left out: no z-scores</summary>
        public Norms Norms { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.AnthropometryOptions*)at;
            Functions.mien_anthropometry_options_init(at, (UIntPtr)sizeof(Native.AnthropometryOptions));
            raw->placeSd = call.Matrix(PlaceSd, 1, "place_sd");
            raw->normalSd = call.Matrix(NormalSd, 1, "normal_sd");
            raw->slideCorrelationMm = SlideCorrelationMm;
            raw->normalCorrelationMm = NormalCorrelationMm;
            raw->norms = call.UseOrNull(Norms);
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.AnthropometryOptions));
            Fill(call, at);
            var raw = (Native.AnthropometryOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }

    /// <summary>One measurement of a face. NaN where a number is not known.</summary>
    public sealed unsafe class AnthropometricValue
    {
        /// <summary>MIEN_MEASURE_*</summary>
        public Measure Kind { get; internal set; }
        /// <summary>NaN: mien_anthropometry_get_reason() says why</summary>
        public double Value { get; internal set; }
        /// <summary>of the value, by the errors of the landmarks' places</summary>
        public double Sd { get; internal set; }
        /// <summary>(value - norm_mean) / norm_sd</summary>
        public double Z { get; internal set; }
        /// <summary>sd / norm_sd</summary>
        public double ZSd { get; internal set; }
        /// <summary>over the people of the norms</summary>
        public double NormMean { get; internal set; }
        public double NormSd { get; internal set; }
        /// <summary>0: no norm</summary>
        public ulong NormPeople { get; internal set; }

        internal static AnthropometricValue Read(Call call, IntPtr at)
        {
            var raw = (Native.AnthropometricValue*)at;
            var made = new AnthropometricValue();
            made.Kind = (Measure)raw->kind;
            made.Value = raw->value;
            made.Sd = raw->sd;
            made.Z = raw->z;
            made.ZSd = raw->zSd;
            made.NormMean = raw->normMean;
            made.NormSd = raw->normSd;
            made.NormPeople = raw->normPeople;
            return made;
        }
    }

    /// <summary>mien_measure_options of the C interface.</summary>
    public sealed unsafe class MeasureOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public MeasureOptions()
        {
            var raw = default(Native.MeasureOptions);
            Functions.mien_measure_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.MeasureOptions));
            SkipBorders = raw.skipBorders;
            CorrelationLengthMm = raw.correlationLengthMm;
            AlignmentRotationSdRad = raw.alignmentRotationSdRad;
            AlignmentTranslationSdMm = raw.alignmentTranslationSdMm;
            AlignmentCentre = Call.CopyOut(raw.alignmentCentre, 3);
            CommonBiasMm = raw.commonBiasMm;
            LimitOfDetectionMl = raw.limitOfDetectionMl;
            MaxDistanceMm = raw.maxDistanceMm;
        }

        /// <summary>surfaces not in correspondence: 1 (default) leaves out places whose partner lies on an open border, where
        /// nothing is known</summary>
        public int SkipBorders { get; set; }
        /// <summary>zone_count zones; null: the whole face only</summary>
        public IReadOnlyList<Zone> Zones { get; set; }
        /// <summary>#V, mm: deviation of each vertex along the normal, as MIEN_REGISTRATION_NORMAL_DEVIATION_MM tells it; count 0:
        /// exact. Without that of either face there is no interval (since 0.2), whatever the alignment's</summary>
        public Values BeforeSd { get; set; }
        public Values AfterSd { get; set; }
        /// <summary>over which errors of a surface go together; default 4, in 0.1: 10</summary>
        public double CorrelationLengthMm { get; set; }
        /// <summary>of the after face against the before face; default 0</summary>
        public double AlignmentRotationSdRad { get; set; }
        /// <summary>default 0</summary>
        public double AlignmentTranslationSdMm { get; set; }
        /// <summary>mm; what the alignment turns about, e.g. the stable zone's centre</summary>
        public double[] AlignmentCentre { get; set; }
        /// <summary>error common to all vertices; default 0</summary>
        public double CommonBiasMm { get; set; }
        /// <summary>smaller changes are marked as below it; default 0: unknown</summary>
        public double LimitOfDetectionMl { get; set; }
        /// <summary>surfaces not in correspondence: farther partners are none; default 0: no limit</summary>
        public double MaxDistanceMm { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.MeasureOptions*)at;
            Functions.mien_measure_options_init(at, (UIntPtr)sizeof(Native.MeasureOptions));
            raw->skipBorders = SkipBorders;
            raw->beforeSd = call.Matrix(BeforeSd, 1, "before_sd");
            raw->afterSd = call.Matrix(AfterSd, 1, "after_sd");
            raw->correlationLengthMm = CorrelationLengthMm;
            raw->alignmentRotationSdRad = AlignmentRotationSdRad;
            raw->alignmentTranslationSdMm = AlignmentTranslationSdMm;
            raw->commonBiasMm = CommonBiasMm;
            raw->limitOfDetectionMl = LimitOfDetectionMl;
            raw->maxDistanceMm = MaxDistanceMm;
            raw->zones = call.Records(Zones, sizeof(Native.Zone));
            raw->zoneCount = (ulong)call.Rows(Zones, 1, "zones");
            Call.CopyIn(AlignmentCentre, raw->alignmentCentre, 3, "alignment_centre");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.MeasureOptions));
            Fill(call, at);
            var raw = (Native.MeasureOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }

    /// <summary>Volume of one zone, mL. signed = positive + negative, absolute = positive - negative; positive: the after face
    /// lies outside. NaN where a number is not known.</summary>
    public sealed unsafe class ZoneVolume
    {
        /// <summary>1: |signed| reaches the limit of detection, 0: below it, -1: no limit given</summary>
        public int Detected { get; internal set; }
        public double SignedMl { get; internal set; }
        /// <summary>&gt;= 0</summary>
        public double PositiveMl { get; internal set; }
        /// <summary>&lt;= 0</summary>
        public double NegativeMl { get; internal set; }
        public double AbsoluteMl { get; internal set; }
        /// <summary>of signed_ml; NaN when no deviation was given</summary>
        public double SdMl { get; internal set; }
        /// <summary>95 % interval of signed_ml</summary>
        public double Low95Ml { get; internal set; }
        public double High95Ml { get; internal set; }
        public double AreaBeforeMm2 { get; internal set; }
        /// <summary>NaN for surfaces not in correspondence</summary>
        public double AreaAfterMm2 { get; internal set; }

        internal static ZoneVolume Read(Call call, IntPtr at)
        {
            var raw = (Native.ZoneVolume*)at;
            var made = new ZoneVolume();
            made.Detected = raw->detected;
            made.SignedMl = raw->signedMl;
            made.PositiveMl = raw->positiveMl;
            made.NegativeMl = raw->negativeMl;
            made.AbsoluteMl = raw->absoluteMl;
            made.SdMl = raw->sdMl;
            made.Low95Ml = raw->low95Ml;
            made.High95Ml = raw->high95Ml;
            made.AreaBeforeMm2 = raw->areaBeforeMm2;
            made.AreaAfterMm2 = raw->areaAfterMm2;
            return made;
        }
    }

    /// <summary>Distances of one zone, mm, weighted with area.</summary>
    public sealed unsafe class ZoneDistance
    {
        /// <summary>along the normal of the before face; positive: outside</summary>
        public double MeanSignedMm { get; internal set; }
        public double SdSignedMm { get; internal set; }
        /// <summary>of the signed ones</summary>
        public double MeanAbsoluteMm { get; internal set; }
        /// <summary>of the lengths</summary>
        public double RmsMm { get; internal set; }
        public double MeanLengthMm { get; internal set; }
        public double MedianLengthMm { get; internal set; }
        public double P95LengthMm { get; internal set; }
        public double MaxLengthMm { get; internal set; }
        /// <summary>vertices that had a partner</summary>
        public ulong VertexCount { get; internal set; }

        internal static ZoneDistance Read(Call call, IntPtr at)
        {
            var raw = (Native.ZoneDistance*)at;
            var made = new ZoneDistance();
            made.MeanSignedMm = raw->meanSignedMm;
            made.SdSignedMm = raw->sdSignedMm;
            made.MeanAbsoluteMm = raw->meanAbsoluteMm;
            made.RmsMm = raw->rmsMm;
            made.MeanLengthMm = raw->meanLengthMm;
            made.MedianLengthMm = raw->medianLengthMm;
            made.P95LengthMm = raw->p95LengthMm;
            made.MaxLengthMm = raw->maxLengthMm;
            made.VertexCount = raw->vertexCount;
            return made;
        }
    }

    /// <summary>A rigid alignment on a stable zone and how sure it is.</summary>
    public sealed unsafe class ZoneAlignment
    {
        /// <summary>that counted</summary>
        public ulong Pairs { get; internal set; }
        /// <summary>left over along the normals</summary>
        public double RmsMm { get; internal set; }
        /// <summary>about the centre, root mean square over the axes</summary>
        public double RotationSdRad { get; internal set; }
        /// <summary>per axis, root mean square</summary>
        public double TranslationSdMm { get; internal set; }
        /// <summary>of the zone on the target</summary>
        public double[] Centre { get; internal set; }
        /// <summary>4 x 4 row by row, moving to target</summary>
        public double[] Matrix { get; internal set; }

        internal static ZoneAlignment Read(Call call, IntPtr at)
        {
            var raw = (Native.ZoneAlignment*)at;
            var made = new ZoneAlignment();
            made.Pairs = raw->pairs;
            made.RmsMm = raw->rmsMm;
            made.RotationSdRad = raw->rotationSdRad;
            made.TranslationSdMm = raw->translationSdMm;
            made.Centre = Call.CopyOut(raw->centre, 3);
            made.Matrix = Call.CopyOut(raw->matrix, 16);
            return made;
        }
    }

    /// <summary>mien_asymmetry_options of the C interface.</summary>
    public sealed unsafe class AsymmetryOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public AsymmetryOptions()
        {
            var raw = default(Native.AsymmetryOptions);
            Functions.mien_asymmetry_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.AsymmetryOptions));
            Plane = (MirrorBy)raw.plane;
            CorrelationLengthMm = raw.correlationLengthMm;
        }

        /// <summary>MIEN_MIRROR_BY_*; default by the surface</summary>
        public MirrorBy Plane { get; set; }
        /// <summary>zone_count zones of either side; null: the whole side only</summary>
        public IReadOnlyList<Zone> Zones { get; set; }
        /// <summary>of the template, vertices; may be left out unless the plane is found by them</summary>
        public Landmarks Landmarks { get; set; }
        /// <summary>#V, mm: deviation of each vertex along the normal, as MIEN_REGISTRATION_NORMAL_DEVIATION_MM tells it; count 0:
        /// not known, and no interval</summary>
        public Values NormalSd { get; set; }
        /// <summary>over which errors of the surface go together; default 4</summary>
        public double CorrelationLengthMm { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.AsymmetryOptions*)at;
            Functions.mien_asymmetry_options_init(at, (UIntPtr)sizeof(Native.AsymmetryOptions));
            raw->plane = (int)Plane;
            raw->normalSd = call.Matrix(NormalSd, 1, "normal_sd");
            raw->correlationLengthMm = CorrelationLengthMm;
            raw->zones = call.Records(Zones, sizeof(Native.Zone));
            raw->zoneCount = (ulong)call.Rows(Zones, 1, "zones");
            raw->landmarks = call.UseOrNull(Landmarks);
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.AsymmetryOptions));
            Fill(call, at);
            var raw = (Native.AsymmetryOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }

    /// <summary>The plane between left and right. NaN where a number is not known.</summary>
    public sealed unsafe class MirrorPlane
    {
        /// <summary>MIEN_MIRROR_BY_*</summary>
        public MirrorBy By { get; internal set; }
        /// <summary>of partners that counted</summary>
        public ulong Pairs { get; internal set; }
        /// <summary>unit, to the subject's left</summary>
        public double[] Normal { get; internal set; }
        /// <summary>mm, in the plane</summary>
        public double[] Centre { get; internal set; }
        /// <summary>of the distances between a side and the other's reflection</summary>
        public double RmsMm { get; internal set; }
        /// <summary>about either direction of the plane, root mean square</summary>
        public double TiltSdRad { get; internal set; }
        /// <summary>along the normal</summary>
        public double OffsetSdMm { get; internal set; }
        /// <summary>angle to the plane found the other way; NaN without landmarks</summary>
        public double BetweenRad { get; internal set; }
        /// <summary>of that plane from the centre, along its normal</summary>
        public double ApartMm { get; internal set; }

        internal static MirrorPlane Read(Call call, IntPtr at)
        {
            var raw = (Native.MirrorPlane*)at;
            var made = new MirrorPlane();
            made.By = (MirrorBy)raw->by;
            made.Pairs = raw->pairs;
            made.Normal = Call.CopyOut(raw->normal, 3);
            made.Centre = Call.CopyOut(raw->centre, 3);
            made.RmsMm = raw->rmsMm;
            made.TiltSdRad = raw->tiltSdRad;
            made.OffsetSdMm = raw->offsetSdMm;
            made.BetweenRad = raw->betweenRad;
            made.ApartMm = raw->apartMm;
            return made;
        }
    }

    /// <summary>mien_spectral_basis_options of the C interface.</summary>
    public sealed unsafe class SpectralBasisOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public SpectralBasisOptions()
        {
            var raw = default(Native.SpectralBasisOptions);
            Functions.mien_spectral_basis_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.SpectralBasisOptions));
            ModeCount = raw.modeCount;
            Mass = (Mass)raw.mass;
            Cotangents = (Cotangents)raw.cotangents;
        }

        /// <summary>1 to #V - 1; default 500</summary>
        public uint ModeCount { get; set; }
        /// <summary>MIEN_MASS_...; default mixed Voronoi</summary>
        public Mass Mass { get; set; }
        /// <summary>MIEN_COTANGENTS_...; default intrinsic Delaunay</summary>
        public Cotangents Cotangents { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.SpectralBasisOptions*)at;
            Functions.mien_spectral_basis_options_init(at, (UIntPtr)sizeof(Native.SpectralBasisOptions));
            raw->modeCount = ModeCount;
            raw->mass = (int)Mass;
            raw->cotangents = (int)Cotangents;
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.SpectralBasisOptions));
            Fill(call, at);
            var raw = (Native.SpectralBasisOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }

    /// <summary>mien_blendshape_options of the C interface.</summary>
    public sealed unsafe class BlendshapeOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public BlendshapeOptions()
        {
            var raw = default(Native.BlendshapeOptions);
            Functions.mien_blendshape_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.BlendshapeOptions));
            Ridge = raw.ridge;
        }

        /// <summary>of the kernel's mean diagonal; default 0: by leave-one-out error</summary>
        public double Ridge { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.BlendshapeOptions*)at;
            Functions.mien_blendshape_options_init(at, (UIntPtr)sizeof(Native.BlendshapeOptions));
            raw->ridge = Ridge;
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.BlendshapeOptions));
            Fill(call, at);
            var raw = (Native.BlendshapeOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }

    /// <summary>One tried k of mien_blendshape_model_search().</summary>
    public sealed unsafe class BandChoice : Record
    {
        public ulong K { get; set; }
        public double L1Mm { get; set; }
        public double Dame { get; set; }
        public double Fmpd { get; set; }
        /// <summary>1: no other k is better in both L1 and FMPD</summary>
        public int OnFront { get; set; }
        /// <summary>1: the front's knee</summary>
        public int Chosen { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.BandChoice*)at;
            raw->k = K;
            raw->l1Mm = L1Mm;
            raw->dame = Dame;
            raw->fmpd = Fmpd;
            raw->onFront = OnFront;
            raw->chosen = Chosen;
        }

        internal static BandChoice Read(Call call, IntPtr at)
        {
            var raw = (Native.BandChoice*)at;
            var made = new BandChoice();
            made.K = raw->k;
            made.L1Mm = raw->l1Mm;
            made.Dame = raw->dame;
            made.Fmpd = raw->fmpd;
            made.OnFront = raw->onFront;
            made.Chosen = raw->chosen;
            return made;
        }
    }

    /// <summary>mien_register_options of the C interface.</summary>
    public sealed unsafe class RegisterOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public RegisterOptions()
        {
            var raw = default(Native.RegisterOptions);
            Functions.mien_register_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.RegisterOptions));
            Growth = (Growth)raw.growth;
            LandmarkSigmaMm = raw.landmarkSigmaMm;
            Start = (Start)raw.start;
            Units = (Units)raw.units;
            SkinWeights = raw.skinWeights;
            CloseGap = raw.closeGap;
            MaxScalarModes = raw.maxScalarModes;
            MaxPcaModes = raw.maxPcaModes;
            Iterations = raw.iterations;
            RejectBorder = raw.rejectBorder;
            SigmaStartMm = raw.sigmaStartMm;
            SigmaEndMm = raw.sigmaEndMm;
            MaxAngleDeg = raw.maxAngleDeg;
            StartRotation = Call.CopyOut(raw.startRotation, 9);
            StartTranslation = Call.CopyOut(raw.startTranslation, 3);
            StartScale = raw.startScale;
            ColorFeatures = raw.colorFeatures;
            UnitToMm = raw.unitToMm;
            LandmarkSides = (Sides)raw.landmarkSides;
            MaxDistanceMm = raw.maxDistanceMm;
            MutualMm = raw.mutualMm;
            SoftMm = raw.softMm;
        }

        /// <summary>MIEN_GROWTH_*; default constant, with annealed noise</summary>
        public Growth Growth { get; set; }
        /// <summary>landmark_count landmarks; null: none</summary>
        public IReadOnlyList<ScanLandmark> Landmarks { get; set; }
        /// <summary>picking error per axis, &gt; 0; default 2</summary>
        public double LandmarkSigmaMm { get; set; }
        /// <summary>MIEN_START_*; default automatic</summary>
        public Start Start { get; set; }
        /// <summary>MIEN_UNITS_*; default detect</summary>
        public Units Units { get; set; }
        /// <summary>one weight in [0, 1] per scan vertex; count 0: all one</summary>
        public Values ScanWeights { get; set; }
        /// <summary>1: weigh scan vertices by the probability of skin colour; default 0</summary>
        public int SkinWeights { get; set; }
        /// <summary>1 (default): a smooth field closes what the modes leave open</summary>
        public int CloseGap { get; set; }
        /// <summary>of the model's kernel modes; default -1: all</summary>
        public int MaxScalarModes { get; set; }
        /// <summary>of the model's trained modes; default -1: all</summary>
        public int MaxPcaModes { get; set; }
        /// <summary>1 to 10000; default 0: as many as the library thinks right</summary>
        public int Iterations { get; set; }
        /// <summary>1 (default): places on the scan's open border do not pull</summary>
        public int RejectBorder { get; set; }
        /// <summary>noise level of a surface point in the first round; default 3</summary>
        public double SigmaStartMm { get; set; }
        /// <summary>and in the last; default 0.5</summary>
        public double SigmaEndMm { get; set; }
        /// <summary>between the normals of a vertex and its place; default 60</summary>
        public double MaxAngleDeg { get; set; }
        /// <summary>row by row, template to scan; default identity</summary>
        public double[] StartRotation { get; set; }
        /// <summary>mm</summary>
        public double[] StartTranslation { get; set; }
        /// <summary>default 1</summary>
        public double StartScale { get; set; }
        /// <summary>1 (default): where the scan has vertex colours, its lips and brows hold the fit along the skin, and without
        /// landmarks eyes are seen to be shut; 0: by form alone. Needs landmarks of the 68-point scheme in the model
        /// (brow_*, mouth_outer_*, eye_*) or its zone "lips"</summary>
        public int ColorFeatures { get; set; }
        /// <summary>one unit of the scan in mm when it is known, e.g. 25.4; 0 (default): by `units` and by the landmarks, which
        /// settle it</summary>
        public double UnitToMm { get; set; }
        /// <summary>MIEN_SIDES_*; default refuse</summary>
        public Sides LandmarkSides { get; set; }
        /// <summary>places of the scan that are farther from their vertex do not pull, nearly so far ones less; default 0: as the
        /// noise level lets. Since 0.2</summary>
        public double MaxDistanceMm { get; set; }
        /// <summary>a place pulls a vertex while the vertex that is nearest to the place lies no farther than that from it; default
        /// 0: not asked. Below the template's spacing hardly any place pulls. Since 0.2</summary>
        public double MutualMm { get; set; }
        /// <summary>soft assignment: a vertex is pulled to the mean of the scan around its nearest place, weighed by a Gaussian of
        /// this deviation; default 0: to the place itself. Since 0.2</summary>
        public double SoftMm { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.RegisterOptions*)at;
            Functions.mien_register_options_init(at, (UIntPtr)sizeof(Native.RegisterOptions));
            raw->growth = (int)Growth;
            raw->landmarkSigmaMm = LandmarkSigmaMm;
            raw->start = (int)Start;
            raw->units = (int)Units;
            raw->scanWeights = call.Matrix(ScanWeights, 1, "scan_weights");
            raw->skinWeights = SkinWeights;
            raw->closeGap = CloseGap;
            raw->maxScalarModes = MaxScalarModes;
            raw->maxPcaModes = MaxPcaModes;
            raw->iterations = Iterations;
            raw->rejectBorder = RejectBorder;
            raw->sigmaStartMm = SigmaStartMm;
            raw->sigmaEndMm = SigmaEndMm;
            raw->maxAngleDeg = MaxAngleDeg;
            raw->startScale = StartScale;
            raw->colorFeatures = ColorFeatures;
            raw->unitToMm = UnitToMm;
            raw->landmarkSides = (int)LandmarkSides;
            raw->maxDistanceMm = MaxDistanceMm;
            raw->mutualMm = MutualMm;
            raw->softMm = SoftMm;
            raw->landmarks = call.Records(Landmarks, sizeof(Native.ScanLandmark));
            raw->landmarkCount = (ulong)call.Rows(Landmarks, 1, "landmarks");
            Call.CopyIn(StartRotation, raw->startRotation, 9, "start_rotation");
            Call.CopyIn(StartTranslation, raw->startTranslation, 3, "start_translation");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.RegisterOptions));
            Fill(call, at);
            var raw = (Native.RegisterOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }

    /// <summary>The verdict on a fit; the reasons in words are in the JSON report. The quality is that of the error expected of
    /// the whole face (mien_registration_get_expected_error()), doubtful at best where a zone has failed.</summary>
    public sealed unsafe class FitVerdict
    {
        /// <summary>MIEN_QUALITY_*</summary>
        public Quality Quality { get; internal set; }
        /// <summary>share of the template's vertices with a scan beside them</summary>
        public double Coverage { get; internal set; }
        /// <summary>of those: share that lies on the scan</summary>
        public double InlierShare { get; internal set; }
        public double MeanResidualMm { get; internal set; }
        /// <summary>0 without landmarks</summary>
        public double LandmarkRmsMm { get; internal set; }
        /// <summary>fitted size over template size</summary>
        public double SizeRatio { get; internal set; }
        /// <summary>of the coefficients, in standard deviations of the prior</summary>
        public double MeanDeviation { get; internal set; }
        /// <summary>what one unit of the scan was taken for</summary>
        public double UnitToMm { get; internal set; }
        public int LandmarksUsed { get; internal set; }
        public int LandmarksRejected { get; internal set; }
        public int FlippedTriangles { get; internal set; }
        public int SelfIntersections { get; internal set; }

        internal static FitVerdict Read(Call call, IntPtr at)
        {
            var raw = (Native.FitVerdict*)at;
            var made = new FitVerdict();
            made.Quality = (Quality)raw->quality;
            made.Coverage = raw->coverage;
            made.InlierShare = raw->inlierShare;
            made.MeanResidualMm = raw->meanResidualMm;
            made.LandmarkRmsMm = raw->landmarkRmsMm;
            made.SizeRatio = raw->sizeRatio;
            made.MeanDeviation = raw->meanDeviation;
            made.UnitToMm = raw->unitToMm;
            made.LandmarksUsed = raw->landmarksUsed;
            made.LandmarksRejected = raw->landmarksRejected;
            made.FlippedTriangles = raw->flippedTriangles;
            made.SelfIntersections = raw->selfIntersections;
            return made;
        }
    }

    /// <summary>How far a fitted zone is expected to be from the truth: the mean distance of its vertices from the true ones,
    /// learned from simulated fits of many people, poses and troubles. Since 0.2</summary>
    public sealed unsafe class ExpectedError
    {
        /// <summary>MIEN_QUALITY_*, of the zone alone</summary>
        public Quality Quality { get; internal set; }
        public double ExpectedMm { get; internal set; }
        /// <summary>8 of 10 like fits are between low_mm and high_mm off</summary>
        public double LowMm { get; internal set; }
        public double HighMm { get; internal set; }
        /// <summary>0 to 1: share of the zone that the scan had no say in</summary>
        public double Unseen { get; internal set; }

        internal static ExpectedError Read(Call call, IntPtr at)
        {
            var raw = (Native.ExpectedError*)at;
            var made = new ExpectedError();
            made.Quality = (Quality)raw->quality;
            made.ExpectedMm = raw->expectedMm;
            made.LowMm = raw->lowMm;
            made.HighMm = raw->highMm;
            made.Unseen = raw->unseen;
            return made;
        }
    }

    /// <summary>mien_neutralize_options of the C interface.</summary>
    public sealed unsafe class NeutralizeOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public NeutralizeOptions()
        {
            var raw = default(Native.NeutralizeOptions);
            Functions.mien_neutralize_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.NeutralizeOptions));
            Method = (Fit)raw.method;
            MaxSweeps = raw.maxSweeps;
            Uncertainty = raw.uncertainty;
            Pose = (Pose)raw.pose;
            ToleranceMm = raw.toleranceMm;
            NoiseMm2 = raw.noiseMm2;
            DecayMm = raw.decayMm;
            TreatedMarginMm = raw.treatedMarginMm;
        }

        /// <summary>MIEN_FIT_..., default MIEN_FIT_MIXTURE</summary>
        public Fit Method { get; set; }
        /// <summary>alternating; 1 to 100000, default 200</summary>
        public int MaxSweeps { get; set; }
        /// <summary>1: compute the deviation per vertex; default 0</summary>
        public int Uncertainty { get; set; }
        /// <summary>MIEN_POSE_..., default MIEN_POSE_AUTO</summary>
        public Pose Pose { get; set; }
        /// <summary>alternating: stop when a sweep moves less; default 1e-6</summary>
        public double ToleranceMm { get; set; }
        /// <summary>0 (default): the model's own</summary>
        public double NoiseMm2 { get; set; }
        /// <summary>how far a displacement reaches beyond the model's rim; default 25</summary>
        public double DecayMm { get; set; }
        /// <summary>#V x 1, &gt;= 0: 0 where the scan had no data; count 0: all one</summary>
        public Values Weights { get; set; }
        /// <summary>treated_count vertices where the person may have been changed: no witness of expression or pose, so that filler
        /// in a lip stays on the face and is not taken for a rolled lip; null: none. Since 0.2</summary>
        public uint[] Treated { get; set; }
        /// <summary>around them, no witness either; treatments spread; 0 to 100, default 10</summary>
        public double TreatedMarginMm { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.NeutralizeOptions*)at;
            Functions.mien_neutralize_options_init(at, (UIntPtr)sizeof(Native.NeutralizeOptions));
            raw->method = (int)Method;
            raw->maxSweeps = MaxSweeps;
            raw->uncertainty = Uncertainty;
            raw->pose = (int)Pose;
            raw->toleranceMm = ToleranceMm;
            raw->noiseMm2 = NoiseMm2;
            raw->decayMm = DecayMm;
            raw->weights = call.Matrix(Weights, 1, "weights");
            raw->treatedMarginMm = TreatedMarginMm;
            raw->treated = call.Array(Treated);
            raw->treatedCount = (ulong)call.Rows(Treated, 1, "treated");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.NeutralizeOptions));
            Fill(call, at);
            var raw = (Native.NeutralizeOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }

    /// <summary>What a reading takes off inside the treated zone (without its margin).</summary>
    public sealed unsafe class ZoneReading
    {
        /// <summary>1: the two readings see another expression and another volume</summary>
        public int Differ { get; internal set; }
        /// <summary>of the likeliest expression, which the JSON names</summary>
        public double Probability { get; internal set; }
        /// <summary>root mean square over the zone</summary>
        public double RemovedMm { get; internal set; }
        /// <summary>by which the zone stood out through the expression, to first order</summary>
        public double RemovedMl { get; internal set; }

        internal static ZoneReading Read(Call call, IntPtr at)
        {
            var raw = (Native.ZoneReading*)at;
            var made = new ZoneReading();
            made.Differ = raw->differ;
            made.Probability = raw->probability;
            made.RemovedMm = raw->removedMm;
            made.RemovedMl = raw->removedMl;
            return made;
        }
    }

    /// <summary>mien_evaluate_options of the C interface.</summary>
    public sealed unsafe class EvaluateOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public EvaluateOptions()
        {
            var raw = default(Native.EvaluateOptions);
            Functions.mien_evaluate_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.EvaluateOptions));
            Method = (Fit)raw.method;
            MaxSweeps = raw.maxSweeps;
            AgainstMethod = (Fit)raw.againstMethod;
            AgainstMaxSweeps = raw.againstMaxSweeps;
        }

        /// <summary>MIEN_FIT_..., default MIEN_FIT_MIXTURE</summary>
        public Fit Method { get; set; }
        /// <summary>of the method; default 200</summary>
        public int MaxSweeps { get; set; }
        /// <summary>MIEN_FIT_... of the second model; default MIEN_FIT_ALTERNATING</summary>
        public Fit AgainstMethod { get; set; }
        /// <summary>default 3</summary>
        public int AgainstMaxSweeps { get; set; }
        /// <summary>second model to compare with; may be left out</summary>
        public ExpressionModel Against { get; set; }
        /// <summary>measure on these vertices only; null: all</summary>
        public uint[] ZoneVertices { get; set; }
        /// <summary>align every face rigidly to its target on these first; null: not</summary>
        public uint[] StableVertices { get; set; }
        /// <summary>absolute volumes to the neutral face are measured in these, too; null: none. Since 0.2</summary>
        public IReadOnlyList<Zone> VolumeZones { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.EvaluateOptions*)at;
            Functions.mien_evaluate_options_init(at, (UIntPtr)sizeof(Native.EvaluateOptions));
            raw->method = (int)Method;
            raw->maxSweeps = MaxSweeps;
            raw->againstMethod = (int)AgainstMethod;
            raw->againstMaxSweeps = AgainstMaxSweeps;
            raw->against = call.UseOrNull(Against);
            raw->zoneVertices = call.Array(ZoneVertices);
            raw->zoneCount = (ulong)call.Rows(ZoneVertices, 1, "zone_vertices");
            raw->stableVertices = call.Array(StableVertices);
            raw->stableCount = (ulong)call.Rows(StableVertices, 1, "stable_vertices");
            raw->volumeZones = call.Records(VolumeZones, sizeof(Native.Zone));
            raw->volumeZoneCount = (ulong)call.Rows(VolumeZones, 1, "volume_zones");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.EvaluateOptions));
            Fill(call, at);
            var raw = (Native.EvaluateOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }

    /// <summary>mien_geodesic_options of the C interface.</summary>
    public sealed unsafe class GeodesicOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public GeodesicOptions()
        {
            var raw = default(Native.GeodesicOptions);
            Functions.mien_geodesic_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.GeodesicOptions));
            HeatBoundary = (Heat)raw.heatBoundary;
            HeatTimeFactor = raw.heatTimeFactor;
        }

        /// <summary>MIEN_HEAT_..., default NEUMANN</summary>
        public Heat HeatBoundary { get; set; }
        /// <summary>heat time in units of (mean edge)^2, 0.01 to 10000, default 4</summary>
        public double HeatTimeFactor { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.GeodesicOptions*)at;
            Functions.mien_geodesic_options_init(at, (UIntPtr)sizeof(Native.GeodesicOptions));
            raw->heatBoundary = (int)HeatBoundary;
            raw->heatTimeFactor = HeatTimeFactor;
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.GeodesicOptions));
            Fill(call, at);
            var raw = (Native.GeodesicOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }

    /// <summary>mien_model_fit_options of the C interface.</summary>
    public sealed unsafe class ModelFitOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public ModelFitOptions()
        {
            var raw = default(Native.ModelFitOptions);
            Functions.mien_model_fit_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.ModelFitOptions));
            Align = raw.align;
            RidgeMm2 = raw.ridgeMm2;
            ScalarModes = raw.scalarModes;
            VectorModes = raw.vectorModes;
        }

        /// <summary>1: move the target rigidly onto the model's mean; default 0</summary>
        public int Align { get; set; }
        /// <summary>rho: variance of the target's noise, mm^2, &gt;= 0; default 1</summary>
        public double RidgeMm2 { get; set; }
        /// <summary>one per vertex of the target, &gt;= 0, which enter squared; count 0: all one</summary>
        public Values Weights { get; set; }
        /// <summary>the first of them, the others stay 0; -1 (default): all</summary>
        public int ScalarModes { get; set; }
        /// <summary>the first of them, the others stay 0; -1 (default): all</summary>
        public int VectorModes { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.ModelFitOptions*)at;
            Functions.mien_model_fit_options_init(at, (UIntPtr)sizeof(Native.ModelFitOptions));
            raw->align = Align;
            raw->ridgeMm2 = RidgeMm2;
            raw->weights = call.Matrix(Weights, 1, "weights");
            raw->scalarModes = ScalarModes;
            raw->vectorModes = VectorModes;
        }
    }

    /// <summary>How to run; initialise with mien_network_options_init().</summary>
    public sealed unsafe class NetworkOptions : Record
    {
        /// <summary>may be left out; looked at between layers</summary>
        public Cancel Cancel { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.NetworkOptions*)at;
            Functions.mien_network_options_init(at, (UIntPtr)sizeof(Native.NetworkOptions));
            raw->cancel = call.UseOrNull(Cancel);
        }
    }

    /// <summary>What to evaluate; initialise with mien_network_evaluation_options_init().</summary>
    public sealed unsafe class NetworkEvaluationOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public NetworkEvaluationOptions()
        {
            var raw = default(Native.NetworkEvaluationOptions);
            Functions.mien_network_evaluation_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.NetworkEvaluationOptions));
            NeutralOnly = raw.neutralOnly;
            Perceptual = raw.perceptual;
        }

        /// <summary>1: only the faces marked neutral; default 0: all</summary>
        public int NeutralOnly { get; set; }
        /// <summary>1 (default): DAME and FMPD too; 0: distances alone</summary>
        public int Perceptual { get; set; }
        /// <summary>faces of these subjects; null: of all</summary>
        public int[] Subjects { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.NetworkEvaluationOptions*)at;
            Functions.mien_network_evaluation_options_init(at, (UIntPtr)sizeof(Native.NetworkEvaluationOptions));
            raw->neutralOnly = NeutralOnly;
            raw->perceptual = Perceptual;
            raw->subjects = call.Array(Subjects);
            raw->subjectCount = (ulong)call.Rows(Subjects, 1, "subjects");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.NetworkEvaluationOptions));
            Fill(call, at);
            var raw = (Native.NetworkEvaluationOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }

    /// <summary>How to train; initialise with mien_representation_options_init().</summary>
    public sealed unsafe class RepresentationOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public RepresentationOptions()
        {
            var raw = default(Native.RepresentationOptions);
            Functions.mien_representation_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.RepresentationOptions));
            NeutralOnly = raw.neutralOnly;
        }

        /// <summary>1: only the faces marked neutral; default 0: all</summary>
        public int NeutralOnly { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.RepresentationOptions*)at;
            Functions.mien_representation_options_init(at, (UIntPtr)sizeof(Native.RepresentationOptions));
            raw->neutralOnly = NeutralOnly;
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.RepresentationOptions));
            Fill(call, at);
            var raw = (Native.RepresentationOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }

    /// <summary>mien_score_options of the C interface.</summary>
    public sealed unsafe class ScoreOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public ScoreOptions()
        {
            var raw = default(Native.ScoreOptions);
            Functions.mien_score_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.ScoreOptions));
            Method = (Pls)raw.method;
            NumComponents = raw.numComponents;
            MaxComponents = raw.maxComponents;
            Folds = raw.folds;
            Seed = raw.seed;
            CurvatureShare = raw.curvatureShare;
            CurvatureRadiusMm = raw.curvatureRadiusMm;
            Lowest = raw.lowest;
            Highest = raw.highest;
            Focus = raw.focus;
            Features = (ScoreFeatures)raw.features;
        }

        /// <summary>MIEN_PLS_*; default NIPALS</summary>
        public Pls Method { get; set; }
        /// <summary>0 (default): by cross-validation and the one-standard-error rule</summary>
        public int NumComponents { get; set; }
        /// <summary>tried in cross-validation, 1 to 50; default 10</summary>
        public int MaxComponents { get; set; }
        /// <summary>over subjects; 0: leave one subject out; default 10</summary>
        public int Folds { get; set; }
        /// <summary>of the folds; default 1</summary>
        public ulong Seed { get; set; }
        /// <summary>total variance of the curvature features over that of the displacements; 0: none; default 0.1</summary>
        public double CurvatureShare { get; set; }
        /// <summary>of the fits that estimate curvature; default 8</summary>
        public double CurvatureRadiusMm { get; set; }
        /// <summary>range that predictions are cut to</summary>
        public double Lowest { get; set; }
        /// <summary>equal (default): none</summary>
        public double Highest { get; set; }
        /// <summary>of interest; null: all</summary>
        public uint[] ZoneVertices { get; set; }
        /// <summary>faces are aligned on these; null: on all, robustly</summary>
        public uint[] StableVertices { get; set; }
        /// <summary>1 (default): vertices count by how far they move with the score, found anew in each fold; 0: by their area alone</summary>
        public uint Focus { get; set; }
        /// <summary>MIEN_SCORE_FEATURES_*; default displacement and curvature. Since 0.2</summary>
        public ScoreFeatures Features { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.ScoreOptions*)at;
            Functions.mien_score_options_init(at, (UIntPtr)sizeof(Native.ScoreOptions));
            raw->method = (int)Method;
            raw->numComponents = NumComponents;
            raw->maxComponents = MaxComponents;
            raw->folds = Folds;
            raw->seed = Seed;
            raw->curvatureShare = CurvatureShare;
            raw->curvatureRadiusMm = CurvatureRadiusMm;
            raw->lowest = Lowest;
            raw->highest = Highest;
            raw->focus = Focus;
            raw->features = (int)Features;
            raw->zoneVertices = call.Array(ZoneVertices);
            raw->zoneCount = (ulong)call.Rows(ZoneVertices, 1, "zone_vertices");
            raw->stableVertices = call.Array(StableVertices);
            raw->stableCount = (ulong)call.Rows(StableVertices, 1, "stable_vertices");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.ScoreOptions));
            Fill(call, at);
            var raw = (Native.ScoreOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }

    /// <summary>A predicted score.</summary>
    public sealed unsafe class ScorePrediction
    {
        /// <summary>1: the face is unlike the training faces</summary>
        public int Extrapolates { get; internal set; }
        public double Score { get; internal set; }
        /// <summary>95 % prediction interval</summary>
        public double Low95 { get; internal set; }
        public double High95 { get; internal set; }
        /// <summary>distance from the training faces, about components / faces on average</summary>
        public double Leverage { get; internal set; }

        internal static ScorePrediction Read(Call call, IntPtr at)
        {
            var raw = (Native.ScorePrediction*)at;
            var made = new ScorePrediction();
            made.Extrapolates = raw->extrapolates;
            made.Score = raw->score;
            made.Low95 = raw->low95;
            made.High95 = raw->high95;
            made.Leverage = raw->leverage;
            return made;
        }
    }

    /// <summary>mien_series_options of the C interface.</summary>
    public sealed unsafe class SeriesOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public SeriesOptions()
        {
            var raw = default(Native.SeriesOptions);
            Functions.mien_series_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.SeriesOptions));
            Method = (Fit)raw.method;
            Pose = (Pose)raw.pose;
            ScanNoiseShare = raw.scanNoiseShare;
            NoiseMm2 = raw.noiseMm2;
            ExpectedChangeMm = raw.expectedChangeMm;
        }

        /// <summary>MIEN_FIT_MIXTURE (default) or MIEN_FIT_MAP</summary>
        public Fit Method { get; set; }
        /// <summary>MIEN_POSE_..., default MIEN_POSE_AUTO</summary>
        public Pose Pose { get; set; }
        /// <summary>what differs between scans beyond the model, as a share of the noise variance; default 0.01</summary>
        public double ScanNoiseShare { get; set; }
        /// <summary>noise variance; 0 (default): the model's own</summary>
        public double NoiseMm2 { get; set; }
        /// <summary>where the identity may change between scans; null: nowhere</summary>
        public uint[] ChangingVertices { get; set; }
        /// <summary>&gt; 0, default 5; without effect since 0.2: what lies there is no witness of the expression at all</summary>
        public double ExpectedChangeMm { get; set; }
        /// <summary>face_count x #V, face by face, &gt;= 0: 0 where a scan had no data; count 0: all one.</summary>
        public Values Weights { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.SeriesOptions*)at;
            Functions.mien_series_options_init(at, (UIntPtr)sizeof(Native.SeriesOptions));
            raw->method = (int)Method;
            raw->pose = (int)Pose;
            raw->scanNoiseShare = ScanNoiseShare;
            raw->noiseMm2 = NoiseMm2;
            raw->expectedChangeMm = ExpectedChangeMm;
            raw->weights = call.Matrix(Weights, 1, "weights");
            raw->changingVertices = call.Array(ChangingVertices);
            raw->changingCount = (ulong)call.Rows(ChangingVertices, 1, "changing_vertices");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.SeriesOptions));
            Fill(call, at);
            var raw = (Native.SeriesOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }

    /// <summary>Names are those of zones.</summary>
    public sealed unsafe class StudyOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public StudyOptions()
        {
            var raw = default(Native.StudyOptions);
            Functions.mien_study_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.StudyOptions));
            MarginMm = raw.marginMm;
            Level = raw.level;
            NoiseMm = raw.noiseMm;
            CorrelationLengthMm = raw.correlationLengthMm;
            CommonBiasMm = raw.commonBiasMm;
            UntrainedShare = raw.untrainedShare;
            MinSeenShare = raw.minSeenShare;
        }

        /// <summary>zone_count zones to measure; null: those of the registrations' model</summary>
        public IReadOnlyList<Zone> Zones { get; set; }
        /// <summary>treated_count names: where the person may have changed, no witness of expression or pose; null: none</summary>
        public IReadOnlyList<string> TreatedZones { get; set; }
        /// <summary>stable_count names of zones to align on; null: all but the treated ones when zones are treated and expressions
        /// taken off, otherwise "forehead" and "nose"; without any zone the whole face</summary>
        public IReadOnlyList<string> StableZones { get; set; }
        /// <summary>visit_number_count numbers, the visit of each face, from 0 and ascending: several captures of one visit tell the
        /// limits of detection; null: each face is a visit of its own</summary>
        public int[] Visits { get; set; }
        /// <summary>around the treated zones, 0 to 100, measured with them as zones of their own at the end; default 10</summary>
        public double MarginMm { get; set; }
        /// <summary>of the intervals, above 0 and below 1; default 0.95</summary>
        public double Level { get; set; }
        /// <summary>of a scanner's surface along its normal, where it was seen; default 0.08</summary>
        public double NoiseMm { get; set; }
        /// <summary>over which the errors of a fitted surface go together; default 4</summary>
        public double CorrelationLengthMm { get; set; }
        /// <summary>error common to all vertices; default 0.01</summary>
        public double CommonBiasMm { get; set; }
        /// <summary>of the volume that an expression accounted for: what no training set knew of it; default 0.06</summary>
        public double UntrainedShare { get; set; }
        /// <summary>of a zone's area that both visits must have seen, 0 to 1; default 0.1</summary>
        public double MinSeenShare { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.StudyOptions*)at;
            Functions.mien_study_options_init(at, (UIntPtr)sizeof(Native.StudyOptions));
            raw->marginMm = MarginMm;
            raw->level = Level;
            raw->noiseMm = NoiseMm;
            raw->correlationLengthMm = CorrelationLengthMm;
            raw->commonBiasMm = CommonBiasMm;
            raw->untrainedShare = UntrainedShare;
            raw->minSeenShare = MinSeenShare;
            raw->zones = call.Records(Zones, sizeof(Native.Zone));
            raw->zoneCount = (ulong)call.Rows(Zones, 1, "zones");
            raw->treatedZones = call.Texts(TreatedZones);
            raw->treatedCount = (ulong)call.Rows(TreatedZones, 1, "treated_zones");
            raw->stableZones = call.Texts(StableZones);
            raw->stableCount = (ulong)call.Rows(StableZones, 1, "stable_zones");
            raw->visits = call.Array(Visits);
            raw->visitNumberCount = (ulong)call.Rows(Visits, 1, "visits");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.StudyOptions));
            Fill(call, at);
            var raw = (Native.StudyOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }

    /// <summary>A number with its error. NaN: not known.</summary>
    public sealed unsafe class StudyValue : Record
    {
        public double Value { get; set; }
        /// <summary>standard deviation</summary>
        public double Sd { get; set; }
        /// <summary>of the interval at the study's level</summary>
        public double Low { get; set; }
        /// <summary>of the interval at the study's level</summary>
        public double High { get; set; }
        /// <summary>a smaller size cannot be told from no change</summary>
        public double LimitOfDetection { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.StudyValue*)at;
            raw->value = Value;
            raw->sd = Sd;
            raw->low = Low;
            raw->high = High;
            raw->limitOfDetection = LimitOfDetection;
        }

        internal static StudyValue Read(Call call, IntPtr at)
        {
            var raw = (Native.StudyValue*)at;
            var made = new StudyValue();
            made.Value = raw->value;
            made.Sd = raw->sd;
            made.Low = raw->low;
            made.High = raw->high;
            made.LimitOfDetection = raw->limitOfDetection;
            return made;
        }
    }

    /// <summary>What changed in one zone from one visit to another. Set struct_size first.</summary>
    public sealed unsafe class StudyChange
    {
        /// <summary>MIEN_STUDY_*: why there is no deviation</summary>
        public StudyKind Unknown { get; internal set; }
        /// <summary>gained and lost together; positive: gained</summary>
        public StudyValue SignedMl { get; internal set; }
        /// <summary>&gt;= 0</summary>
        public StudyValue GainedMl { get; internal set; }
        /// <summary>&lt;= 0</summary>
        public StudyValue LostMl { get; internal set; }
        /// <summary>gained without lost</summary>
        public StudyValue AbsoluteMl { get; internal set; }
        public StudyValue AreaChangeMm2 { get; internal set; }
        /// <summary>along the normals of the first face; positive: outside</summary>
        public StudyValue MeanDistanceMm { get; internal set; }
        /// <summary>of signed_ml.sd: by the fitted surfaces</summary>
        public double SurfaceSdMl { get; internal set; }
        /// <summary>by the alignment on the stable zone</summary>
        public double AlignmentSdMl { get; internal set; }
        /// <summary>by the error common to all vertices</summary>
        public double BiasSdMl { get; internal set; }
        /// <summary>by what taking the expressions off leaves open</summary>
        public double ExpressionSdMl { get; internal set; }
        /// <summary>what the expressions accounted for, signed</summary>
        public double ExpressionRemovedMl { get; internal set; }
        /// <summary>of the zone's area, in both visits; NaN: not told</summary>
        public double SeenShare { get; internal set; }
        public double AreaBeforeMm2 { get; internal set; }
        public double AreaAfterMm2 { get; internal set; }
        /// <summary>1: signed_ml reaches its limit of detection, 0: below it, -1: no limit known</summary>
        public int Detected { get; internal set; }

        internal static StudyChange Read(Call call, IntPtr at)
        {
            var raw = (Native.StudyChange*)at;
            var made = new StudyChange();
            made.Unknown = (StudyKind)raw->unknown;
            made.SignedMl = StudyValue.Read(call, (IntPtr)(&raw->signedMl));
            made.GainedMl = StudyValue.Read(call, (IntPtr)(&raw->gainedMl));
            made.LostMl = StudyValue.Read(call, (IntPtr)(&raw->lostMl));
            made.AbsoluteMl = StudyValue.Read(call, (IntPtr)(&raw->absoluteMl));
            made.AreaChangeMm2 = StudyValue.Read(call, (IntPtr)(&raw->areaChangeMm2));
            made.MeanDistanceMm = StudyValue.Read(call, (IntPtr)(&raw->meanDistanceMm));
            made.SurfaceSdMl = raw->surfaceSdMl;
            made.AlignmentSdMl = raw->alignmentSdMl;
            made.BiasSdMl = raw->biasSdMl;
            made.ExpressionSdMl = raw->expressionSdMl;
            made.ExpressionRemovedMl = raw->expressionRemovedMl;
            made.SeenShare = raw->seenShare;
            made.AreaBeforeMm2 = raw->areaBeforeMm2;
            made.AreaAfterMm2 = raw->areaAfterMm2;
            made.Detected = raw->detected;
            return made;
        }
    }

    /// <summary>mien_train_options of the C interface.</summary>
    public sealed unsafe class TrainOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public TrainOptions()
        {
            var raw = default(Native.TrainOptions);
            Functions.mien_train_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.TrainOptions));
            Method = (Train)raw.method;
            IdentityModes = raw.identityModes;
            ExpressionModes = raw.expressionModes;
            MaxIterations = raw.maxIterations;
            Passes = raw.passes;
            Lambda = raw.lambda;
            LambdaFactor = raw.lambdaFactor;
            AngleToleranceRad = raw.angleToleranceRad;
            NoiseMm2 = raw.noiseMm2;
        }

        /// <summary>MIEN_TRAIN_..., default MIEN_TRAIN_JPCA</summary>
        public Train Method { get; set; }
        /// <summary>1 to 4000; 0 (default since 0.2, 50 before): of 25, 50, 75 and 100 the fewest that serve people left out of the
        /// training</summary>
        public int IdentityModes { get; set; }
        /// <summary>1 to 4000; 0 (default): as above</summary>
        public int ExpressionModes { get; set; }
        /// <summary>QOJPCA; default 1000</summary>
        public int MaxIterations { get; set; }
        /// <summary>over the data, 1 to 50, default 4</summary>
        public int Passes { get; set; }
        /// <summary>QOJPCA; 0 (default): lambda_factor x the top eigenvalue of k XX'</summary>
        public double Lambda { get; set; }
        /// <summary>default 10</summary>
        public double LambdaFactor { get; set; }
        /// <summary>QOJPCA stops when no subspace turns farther; default 0.001</summary>
        public double AngleToleranceRad { get; set; }
        /// <summary>noise variance of the fits; 0 (default): by cross-validation</summary>
        public double NoiseMm2 { get; set; }
        /// <summary>posture: every face is aligned rigidly on these vertices (forehead, nose bridge), in training and in every fit;
        /// null: faces as they lie</summary>
        public uint[] StableVertices { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.TrainOptions*)at;
            Functions.mien_train_options_init(at, (UIntPtr)sizeof(Native.TrainOptions));
            raw->method = (int)Method;
            raw->identityModes = IdentityModes;
            raw->expressionModes = ExpressionModes;
            raw->maxIterations = MaxIterations;
            raw->passes = Passes;
            raw->lambda = Lambda;
            raw->lambdaFactor = LambdaFactor;
            raw->angleToleranceRad = AngleToleranceRad;
            raw->noiseMm2 = NoiseMm2;
            raw->stableVertices = call.Array(StableVertices);
            raw->stableCount = (ulong)call.Rows(StableVertices, 1, "stable_vertices");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.TrainOptions));
            Fill(call, at);
            var raw = (Native.TrainOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }

    /// <summary>mien_shard_options of the C interface.</summary>
    public sealed unsafe class ShardOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public ShardOptions()
        {
            var raw = default(Native.ShardOptions);
            Functions.mien_shard_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.ShardOptions));
            Part = raw.part;
            PartCount = raw.partCount;
            MaxRank = raw.maxRank;
        }

        /// <summary>0 to part_count - 1, default 0: which subjects</summary>
        public int Part { get; set; }
        /// <summary>default 1: all subjects</summary>
        public int PartCount { get; set; }
        /// <summary>of identities and of expressions, default 512; parts with fewer subjects and faces are exact</summary>
        public int MaxRank { get; set; }
        /// <summary>as in mien_train_options; all parts of a dataset are aligned alike; null: faces as they lie</summary>
        public uint[] StableVertices { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.ShardOptions*)at;
            Functions.mien_shard_options_init(at, (UIntPtr)sizeof(Native.ShardOptions));
            raw->part = Part;
            raw->partCount = PartCount;
            raw->maxRank = MaxRank;
            raw->stableVertices = call.Array(StableVertices);
            raw->stableCount = (ulong)call.Rows(StableVertices, 1, "stable_vertices");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.ShardOptions));
            Fill(call, at);
            var raw = (Native.ShardOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }

    /// <summary>mien_visits_options of the C interface.</summary>
    public sealed unsafe class VisitsOptions : Record
    {
        /// <summary>With the library's defaults.</summary>
        public VisitsOptions()
        {
            var raw = default(Native.VisitsOptions);
            Functions.mien_visits_options_init((IntPtr)(&raw), (UIntPtr)sizeof(Native.VisitsOptions));
            Pose = (Pose)raw.pose;
            NormalNoiseMm2 = raw.normalNoiseMm2;
            TangentialNoiseMm2 = raw.tangentialNoiseMm2;
        }

        /// <summary>MIEN_POSE_..., default MIEN_POSE_AUTO</summary>
        public Pose Pose { get; set; }
        /// <summary>variance of a fitted vertex along the skin's normal, with what no mode explains; default 0.3</summary>
        public double NormalNoiseMm2 { get; set; }
        /// <summary>along the skin: fits slide; default 30</summary>
        public double TangentialNoiseMm2 { get; set; }
        /// <summary>where the person may have changed: no witness of the expression; null: nowhere</summary>
        public uint[] TreatedVertices { get; set; }
        /// <summary>face_count x #V, face by face, &gt;= 0: 0 where a scan had no data; count 0: all one</summary>
        public Values Weights { get; set; }

        internal override void Fill(Call call, IntPtr at)
        {
            var raw = (Native.VisitsOptions*)at;
            Functions.mien_visits_options_init(at, (UIntPtr)sizeof(Native.VisitsOptions));
            raw->pose = (int)Pose;
            raw->normalNoiseMm2 = NormalNoiseMm2;
            raw->tangentialNoiseMm2 = TangentialNoiseMm2;
            raw->weights = call.Matrix(Weights, 1, "weights");
            raw->treatedVertices = call.Array(TreatedVertices);
            raw->treatedCount = (ulong)call.Rows(TreatedVertices, 1, "treated_vertices");
        }

        internal IntPtr Write(Call call, IProgress<Progress> progress, CancellationToken cancellationToken)
        {
            var at = call.Room(sizeof(Native.VisitsOptions));
            Fill(call, at);
            var raw = (Native.VisitsOptions*)at;
            raw->progress = call.ProgressFunction(progress);
            raw->progressUser = call.ProgressUser;
            raw->cancel = call.CancelToken(cancellationToken);
            return at;
        }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class MeasureLengths
    {
        internal MeasureLengths(double[] straightMm, double[] geodesicMm)
        {
            StraightMm = straightMm;
            GeodesicMm = geodesicMm;
        }

        /// <summary>pair_count values.</summary>
        public double[] StraightMm { get; private set; }
        /// <summary>pair_count values; by the heat method, within about one percent; infinite where no surface joins the two.</summary>
        public double[] GeodesicMm { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class MeasureScanVolume
    {
        internal MeasureScanVolume(double coverage, Measurement @out)
        {
            Coverage = coverage;
            Out = @out;
        }

        /// <summary>may be left out; share of before's area that had a partner, 0 to 1.</summary>
        public double Coverage { get; private set; }
        /// <summary>the measurement.</summary>
        public Measurement Out { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class MeasureAlign
    {
        internal MeasureAlign(ZoneAlignment info, Mesh @out)
        {
            Info = info;
            Out = @out;
        }

        /// <summary>may be left out</summary>
        public ZoneAlignment Info { get; private set; }
        /// <summary>the moved mesh.</summary>
        public Mesh Out { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class SpectralSplit
    {
        internal SpectralSplit(Mesh low, Mesh high)
        {
            Low = low;
            High = high;
        }

        /// <summary>may be left out; the low band's mesh.</summary>
        public Mesh Low { get; private set; }
        /// <summary>may be left out; the high band's mesh.</summary>
        public Mesh High { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class SurfaceTransferPoints
    {
        internal SurfaceTransferPoints(uint[] triangles, double[] barycentric, double[] positions)
        {
            Triangles = triangles;
            Barycentric = barycentric;
            Positions = positions;
        }

        /// <summary>triangle (cloud: vertex) numbers of `surface`.</summary>
        public uint[] Triangles { get; private set; }
        /// <summary>rows of 3 values.</summary>
        public double[] Barycentric { get; private set; }
        /// <summary>rows of 3 values in mm; a lost place keeps where it was.</summary>
        public double[] Positions { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class MeshCounts
    {
        internal MeshCounts(ulong vertexCount, ulong triangleCount)
        {
            VertexCount = vertexCount;
            TriangleCount = triangleCount;
        }

        /// <summary>may be left out; #V.</summary>
        public ulong VertexCount { get; private set; }
        /// <summary>may be left out; #F.</summary>
        public ulong TriangleCount { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class MeshMaterialCounts
    {
        internal MeshMaterialCounts(ulong materialCount, ulong imageCount)
        {
            MaterialCount = materialCount;
            ImageCount = imageCount;
        }

        /// <summary>may be left out.</summary>
        public ulong MaterialCount { get; private set; }
        /// <summary>may be left out.</summary>
        public ulong ImageCount { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class MeshMaterial
    {
        internal MeshMaterial(int image, double red, double green, double blue)
        {
            Image = image;
            Red = red;
            Green = green;
            Blue = blue;
        }

        /// <summary>may be left out; -1: none.</summary>
        public int Image { get; private set; }
        /// <summary>may be left out; 0 to 1.</summary>
        public double Red { get; private set; }
        /// <summary>may be left out; 0 to 1.</summary>
        public double Green { get; private set; }
        /// <summary>may be left out; 0 to 1.</summary>
        public double Blue { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class MeshImageSize
    {
        internal MeshImageSize(uint width, uint height)
        {
            Width = width;
            Height = height;
        }

        /// <summary>may be left out; pixels.</summary>
        public uint Width { get; private set; }
        /// <summary>may be left out; pixels.</summary>
        public uint Height { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class ModelCounts
    {
        internal ModelCounts(ulong vertexCount, ulong scalarModes, ulong vectorModes)
        {
            VertexCount = vertexCount;
            ScalarModes = scalarModes;
            VectorModes = vectorModes;
        }

        /// <summary>may be left out; #V.</summary>
        public ulong VertexCount { get; private set; }
        /// <summary>may be left out; columns of the scalar basis; 3 times as many deformation modes.</summary>
        public ulong ScalarModes { get; private set; }
        /// <summary>may be left out; modes trained on faces.</summary>
        public ulong VectorModes { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class LandmarksCounts
    {
        internal LandmarksCounts(ulong count, ulong pickedCount)
        {
            Count = count;
            PickedCount = pickedCount;
        }

        /// <summary>may be left out.</summary>
        public ulong Count { get; private set; }
        /// <summary>may be left out.</summary>
        public ulong PickedCount { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class LandmarksMark
    {
        internal LandmarksMark(int where, double position, uint vertex)
        {
            Where = where;
            Position = position;
            Vertex = vertex;
        }

        /// <summary>may be left out; MIEN_MARK_*.</summary>
        public int Where { get; private set; }
        /// <summary>may be left out; x, y and z in the file's unit, zeros unless it is a place.</summary>
        public double Position { get; private set; }
        /// <summary>may be left out; 0 unless it is a vertex.</summary>
        public uint Vertex { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class AnthropometryCounts
    {
        internal AnthropometryCounts(ulong count, ulong knownCount)
        {
            Count = count;
            KnownCount = knownCount;
        }

        /// <summary>may be left out.</summary>
        public ulong Count { get; private set; }
        /// <summary>may be left out.</summary>
        public ulong KnownCount { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class MeasurementZones
    {
        internal MeasurementZones(uint zoneCount, int zonesDisjoint)
        {
            ZoneCount = zoneCount;
            ZonesDisjoint = zonesDisjoint;
        }

        /// <summary>may be left out; the number of zones given.</summary>
        public uint ZoneCount { get; private set; }
        /// <summary>may be left out; 1 when no vertex lies in two zones: zones and rest then add up.</summary>
        public int ZonesDisjoint { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class SpectralBasisCounts
    {
        internal SpectralBasisCounts(ulong vertexCount, ulong modeCount)
        {
            VertexCount = vertexCount;
            ModeCount = modeCount;
        }

        /// <summary>may be left out; #V.</summary>
        public ulong VertexCount { get; private set; }
        /// <summary>may be left out; k.</summary>
        public ulong ModeCount { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class RegistrationCorrespondence
    {
        internal RegistrationCorrespondence(uint[] triangles, double[] barycentric)
        {
            Triangles = triangles;
            Barycentric = barycentric;
        }

        /// <summary>numbers.</summary>
        public uint[] Triangles { get; private set; }
        /// <summary>rows of 3 values.</summary>
        public double[] Barycentric { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class ExpressionModelCounts
    {
        internal ExpressionModelCounts(ulong vertexCount, uint identityModes, uint expressionModes)
        {
            VertexCount = vertexCount;
            IdentityModes = identityModes;
            ExpressionModes = expressionModes;
        }

        /// <summary>may be left out; #V.</summary>
        public ulong VertexCount { get; private set; }
        /// <summary>may be left out.</summary>
        public uint IdentityModes { get; private set; }
        /// <summary>may be left out.</summary>
        public uint ExpressionModes { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class NeutralizationCounts
    {
        internal NeutralizationCounts(ulong vertexCount, uint identityModes, uint expressionModes)
        {
            VertexCount = vertexCount;
            IdentityModes = identityModes;
            ExpressionModes = expressionModes;
        }

        /// <summary>may be left out; #V.</summary>
        public ulong VertexCount { get; private set; }
        /// <summary>may be left out; those of the model.</summary>
        public uint IdentityModes { get; private set; }
        /// <summary>may be left out; those of the model.</summary>
        public uint ExpressionModes { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class NeutralizationCoordinates
    {
        internal NeutralizationCoordinates(double[] identity, double[] expression)
        {
            Identity = identity;
            Expression = expression;
        }

        /// <summary>identity_modes values.</summary>
        public double[] Identity { get; private set; }
        /// <summary>expression_modes values.</summary>
        public double[] Expression { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class HierarchyMap
    {
        internal HierarchyMap(uint[] rows, uint[] columns, double[] values, ulong rowCount, ulong columnCount)
        {
            Rows = rows;
            Columns = columns;
            Values = values;
            RowCount = rowCount;
            ColumnCount = columnCount;
        }

        /// <summary>numbers of vertices that the map ends at.</summary>
        public uint[] Rows { get; private set; }
        /// <summary>numbers of vertices that it starts from.</summary>
        public uint[] Columns { get; private set; }
        /// <summary>float64.</summary>
        public double[] Values { get; private set; }
        /// <summary>may be left out; vertices that the map ends at.</summary>
        public ulong RowCount { get; private set; }
        /// <summary>may be left out; vertices that it starts from.</summary>
        public ulong ColumnCount { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class NetworkCounts
    {
        internal NetworkCounts(ulong vertexCount, ulong codeCount)
        {
            VertexCount = vertexCount;
            CodeCount = codeCount;
        }

        /// <summary>may be left out; #V.</summary>
        public ulong VertexCount { get; private set; }
        /// <summary>may be left out; numbers of a code.</summary>
        public ulong CodeCount { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class NetworkEncode
    {
        internal NetworkEncode(double[] motion, double[] dst)
        {
            Motion = motion;
            Dst = dst;
        }

        /// <summary>may be left out; 12 float64: the rigid motion onto the mean, x -&gt; R x + t, as R row by row, then t in mm.
        /// mien_network_decode() takes it back.</summary>
        public double[] Motion { get; private set; }
        /// <summary>values.</summary>
        public double[] Dst { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class RepresentationCounts
    {
        internal RepresentationCounts(ulong vertexCount, ulong channelCount)
        {
            VertexCount = vertexCount;
            ChannelCount = channelCount;
        }

        /// <summary>may be left out; #V.</summary>
        public ulong VertexCount { get; private set; }
        /// <summary>may be left out; 3, or 9 for deformations.</summary>
        public ulong ChannelCount { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class RepresentationEncode
    {
        internal RepresentationEncode(double[] motion, double[] dst)
        {
            Motion = motion;
            Dst = dst;
        }

        /// <summary>may be left out; 12 float64: the rigid motion onto the mean, x -&gt; R x + t, as R row by row, then t in mm.
        /// mien_representation_decode() takes it back.</summary>
        public double[] Motion { get; private set; }
        /// <summary>rows of channel_count values.</summary>
        public double[] Dst { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class StudyCounts
    {
        internal StudyCounts(uint visitCount, uint zoneCount)
        {
            VisitCount = visitCount;
            ZoneCount = zoneCount;
        }

        /// <summary>may be left out.</summary>
        public uint VisitCount { get; private set; }
        /// <summary>may be left out.</summary>
        public uint ZoneCount { get; private set; }
    }

    /// <summary>What comes out of one call.</summary>
    public sealed class VisitsRemovedVolume
    {
        internal VisitsRemovedVolume(double removedMl, double sdMl)
        {
            RemovedMl = removedMl;
            SdMl = sdMl;
        }

        /// <summary>may be left out; signed, mL.</summary>
        public double RemovedMl { get; private set; }
        /// <summary>may be left out; posterior deviation, mL.</summary>
        public double SdMl { get; private set; }
    }

    /// <summary>Threads, limits of memory and time, and logging. Externally synchronized: one call at a time; with more than one
    /// thread of its own, a session that is in a call on another thread refuses a second call with MIEN_E_BUSY. A
    /// callback may call the library with the session that called it. Objects made in a session may outlive it.</summary>
    public sealed unsafe class Session : NativeObject
    {
        internal Session(IntPtr owned) : base(owned, at => Functions.mien_session_release(at)) { }

        /// <summary>Makes a session with default options: one thread, no memory budget, silent.</summary>
        public Session() : base(Create()) { }

        /// <summary>Makes a session with options of the caller.</summary>
        public Session(SessionOptions options) : base(CreateWithOptions(options)) { }

        /// <summary>Makes a session with default options: one thread, no memory budget, silent.</summary>
        /// <exception cref="MienException">MIEN_E_UNSUPPORTED_VERSION (another ABI), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_session_create()</remarks>
        public static Session Create()
        {
            using (var call = new Call())
            {
                var outAt = call.Room(8);
                call.Check(Functions.mien_session_create(Functions.AbiVersion, outAt, call.Error));
                return call.Keep(new Session(call.Pointer(outAt)));
            }
        }

        /// <summary>Makes a session with options of the caller.</summary>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_ARGUMENT (num_threads), MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_MEMORY
        /// (also when a thread cannot be started)</exception>
        /// <remarks>C: mien_session_create_with_options()</remarks>
        public static Session CreateWithOptions(SessionOptions options = null)
        {
            using (var call = new Call())
            {
                var optionsAt = call.Record(options, sizeof(Native.SessionOptions), true, "options");
                var outAt = call.Room(8);
                call.Check(Functions.mien_session_create_with_options(Functions.AbiVersion, optionsAt, outAt, call.Error));
                return call.Keep(new Session(call.Pointer(outAt)));
            }
        }

        /// <summary>The SHA-256 of a file's bytes as 64 lower-case hexadecimal digits: which model, which scan a result was made
        /// from. With dst null and capacity 0: the size only, without reading the file.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY, MIEN_E_TIME_LIMIT</exception>
        /// <remarks>C: mien_session_hash_file()</remarks>
        public string HashFile(string path)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var pathAt = call.Text(path);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_session_hash_file(sessionAt, pathAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>Lengths, lengths along the skin, angles, inclinations and proportions between the landmarks of a face: some
        /// hundred of the field's, always in the same order. Landmarks go by the field's names ("pronasale",
        /// "cheilion_left") or abbreviations ("prn", "ch_left"), or by those of the 68-point scheme that truly coincide
        /// with one of the field (jaw_08 is gnathion; nose_base_0 is no alare). A measurement whose landmarks are missing
        /// is NaN with a reason.</summary>
        /// <param name="face">#V x 3, mm, with triangles.</param>
        /// <param name="landmarks">vertices of the face, or places on it in its frame (a measurement with a place has no deviation, and no length
        /// along the skin).</param>
        /// <param name="options">may be left out: no deviations, no norms.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (landmarks, deviations),
        /// MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_anthropometry()</remarks>
        public Anthropometry MeasureAnthropometry(Mesh face, Landmarks landmarks, AnthropometryOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var faceAt = call.Use(face);
                var landmarksAt = call.Use(landmarks);
                var optionsAt = (options ?? new AnthropometryOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_measure_anthropometry(sessionAt, faceAt, landmarksAt, optionsAt, outAt, call.Error));
                return call.Keep(new Anthropometry(call.Pointer(outAt)));
            }
        }

        /// <summary>Lengths, lengths along the skin, angles, inclinations and proportions between the landmarks of a face: some
        /// hundred of the field's, always in the same order. Landmarks go by the field's names ("pronasale",
        /// "cheilion_left") or abbreviations ("prn", "ch_left"), or by those of the 68-point scheme that truly coincide
        /// with one of the field (jaw_08 is gnathion; nose_base_0 is no alare). A measurement whose landmarks are missing
        /// is NaN with a reason.</summary>
        /// <param name="face">#V x 3, mm, with triangles.</param>
        /// <param name="landmarks">vertices of the face, or places on it in its frame (a measurement with a place has no deviation, and no length
        /// along the skin).</param>
        /// <param name="options">may be left out: no deviations, no norms.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (landmarks, deviations),
        /// MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_anthropometry()</remarks>
        public Task<Anthropometry> MeasureAnthropometryAsync(Mesh face, Landmarks landmarks, AnthropometryOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => MeasureAnthropometry(face, landmarks, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>The volume between two faces in correspondence: signed, positive, negative and absolute, whole and per zone,
        /// exact where the faces cross inside a triangle pair. A zone's edge runs linearly through the ring of triangles it
        /// shares; disjoint zones and the rest add up to the whole.</summary>
        /// <param name="before">#V x 3, mm, with triangles counter-clockwise seen from outside.</param>
        /// <param name="after">same vertex count, in the frame of before; its triangles are not read.</param>
        /// <param name="options">may be left out: the whole face, no uncertainty.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (no triangles), MIEN_E_MISMATCH (vertex
        /// counts, zones, deviations), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_volume()</remarks>
        public Measurement MeasureVolume(Mesh before, Mesh after, MeasureOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var beforeAt = call.Use(before);
                var afterAt = call.Use(after);
                var optionsAt = (options ?? new MeasureOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_measure_volume(sessionAt, beforeAt, afterAt, optionsAt, outAt, call.Error));
                return call.Keep(new Measurement(call.Pointer(outAt)));
            }
        }

        /// <summary>The volume between two faces in correspondence: signed, positive, negative and absolute, whole and per zone,
        /// exact where the faces cross inside a triangle pair. A zone's edge runs linearly through the ring of triangles it
        /// shares; disjoint zones and the rest add up to the whole.</summary>
        /// <param name="before">#V x 3, mm, with triangles counter-clockwise seen from outside.</param>
        /// <param name="after">same vertex count, in the frame of before; its triangles are not read.</param>
        /// <param name="options">may be left out: the whole face, no uncertainty.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (no triangles), MIEN_E_MISMATCH (vertex
        /// counts, zones, deviations), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_volume()</remarks>
        public Task<Measurement> MeasureVolumeAsync(Mesh before, Mesh after, MeasureOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => MeasureVolume(before, after, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Distances between two faces in correspondence, per vertex and per zone.</summary>
        /// <param name="before">#V x 3, mm.</param>
        /// <param name="after">same vertex count, in the frame of before.</param>
        /// <param name="options">may be left out; zones, progress and cancel are read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH, MIEN_E_NO_MEMORY,
        /// MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_distance()</remarks>
        public Measurement MeasureDistance(Mesh before, Mesh after, MeasureOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var beforeAt = call.Use(before);
                var afterAt = call.Use(after);
                var optionsAt = (options ?? new MeasureOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_measure_distance(sessionAt, beforeAt, afterAt, optionsAt, outAt, call.Error));
                return call.Keep(new Measurement(call.Pointer(outAt)));
            }
        }

        /// <summary>Distances between two faces in correspondence, per vertex and per zone.</summary>
        /// <param name="before">#V x 3, mm.</param>
        /// <param name="after">same vertex count, in the frame of before.</param>
        /// <param name="options">may be left out; zones, progress and cancel are read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH, MIEN_E_NO_MEMORY,
        /// MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_distance()</remarks>
        public Task<Measurement> MeasureDistanceAsync(Mesh before, Mesh after, MeasureOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => MeasureDistance(before, after, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Distances from the vertices of one surface to the closest place on another, in any topology; the Hausdorff
        /// distance takes both directions.</summary>
        /// <param name="before">#V x 3, mm, with triangles.</param>
        /// <param name="after">a surface or a cloud of points, aligned with before.</param>
        /// <param name="options">may be left out; zones (of before), max_distance_mm, skip_borders, progress, cancel.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH, MIEN_E_NO_MEMORY,
        /// MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_surface_distance()</remarks>
        public Measurement MeasureSurfaceDistance(Mesh before, Mesh after, MeasureOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var beforeAt = call.Use(before);
                var afterAt = call.Use(after);
                var optionsAt = (options ?? new MeasureOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_measure_surface_distance(sessionAt, beforeAt, afterAt, optionsAt, outAt, call.Error));
                return call.Keep(new Measurement(call.Pointer(outAt)));
            }
        }

        /// <summary>Distances from the vertices of one surface to the closest place on another, in any topology; the Hausdorff
        /// distance takes both directions.</summary>
        /// <param name="before">#V x 3, mm, with triangles.</param>
        /// <param name="after">a surface or a cloud of points, aligned with before.</param>
        /// <param name="options">may be left out; zones (of before), max_distance_mm, skip_borders, progress, cancel.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH, MIEN_E_NO_MEMORY,
        /// MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_surface_distance()</remarks>
        public Task<Measurement> MeasureSurfaceDistanceAsync(Mesh before, Mesh after, MeasureOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => MeasureSurfaceDistance(before, after, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>The volume that a mesh encloses, by the divergence theorem about its centroid.</summary>
        /// <param name="mesh">manifold along its edges and consistently oriented.</param>
        /// <param name="closeRims">1: each open rim is closed by a fan from the mean of its vertices; 0: an open mesh is an error.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (close_rims), MIEN_E_INVALID_MESH
        /// (open, not manifold or not oriented: the message counts the edges), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_measure_closed_volume()</remarks>
        public double MeasureClosedVolume(Mesh mesh, int closeRims)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var meshAt = call.Use(mesh);
                var volumeMlAt = call.Room(8);
                call.Check(Functions.mien_measure_closed_volume(sessionAt, meshAt, closeRims, volumeMlAt, call.Error));
                return *(double*)volumeMlAt;
            }
        }

        /// <summary>The area of a surface, or of a zone of it (a triangle's area is shared by its three vertices).</summary>
        /// <param name="mesh">with triangles.</param>
        /// <param name="zone">may be left out: the whole surface.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (zone), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_measure_area()</remarks>
        public double MeasureArea(Mesh mesh, Zone zone = null)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var meshAt = call.Use(mesh);
                var zoneAt = call.Record(zone, sizeof(Native.Zone), true, "zone");
                var areaMm2At = call.Room(8);
                call.Check(Functions.mien_measure_area(sessionAt, meshAt, zoneAt, areaMm2At, call.Error));
                return *(double*)areaMm2At;
            }
        }

        /// <summary>Curvatures of a surface, per vertex and per zone, by fits of a cubic around each vertex.</summary>
        /// <param name="mesh">#V x 3, mm, with triangles counter-clockwise seen from outside.</param>
        /// <param name="radiusMm">&gt; 0; of the fits: what is smaller is smoothed away. 6 suits fitted faces.</param>
        /// <param name="robust">1: a second fit leaves spikes and lashes out; 0: none.</param>
        /// <param name="options">may be left out; zones, progress and cancel are read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (robust), MIEN_E_INVALID_MESH,
        /// MIEN_E_MISMATCH (zones), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_curvature()</remarks>
        public Measurement MeasureCurvature(Mesh mesh, double radiusMm, int robust, MeasureOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var meshAt = call.Use(mesh);
                var optionsAt = (options ?? new MeasureOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_measure_curvature(sessionAt, meshAt, radiusMm, robust, optionsAt, outAt, call.Error));
                return call.Keep(new Measurement(call.Pointer(outAt)));
            }
        }

        /// <summary>Curvatures of a surface, per vertex and per zone, by fits of a cubic around each vertex.</summary>
        /// <param name="mesh">#V x 3, mm, with triangles counter-clockwise seen from outside.</param>
        /// <param name="radiusMm">&gt; 0; of the fits: what is smaller is smoothed away. 6 suits fitted faces.</param>
        /// <param name="robust">1: a second fit leaves spikes and lashes out; 0: none.</param>
        /// <param name="options">may be left out; zones, progress and cancel are read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (robust), MIEN_E_INVALID_MESH,
        /// MIEN_E_MISMATCH (zones), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_curvature()</remarks>
        public Task<Measurement> MeasureCurvatureAsync(Mesh mesh, double radiusMm, int robust, MeasureOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => MeasureCurvature(mesh, radiusMm, robust, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Straight lengths and lengths along the surface between pairs of vertices.</summary>
        /// <param name="mesh">#V x 3, mm, with triangles.</param>
        /// <param name="pairs">pair_count x 2 vertex numbers.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (vertex),
        /// MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_measure_lengths()</remarks>
        public MeasureLengths MeasureLengths(Mesh mesh, uint[] pairs)
        {
            using (var call = new Call())
            {
                call.Required(pairs, "pairs");
                call.Lock(this);
                var sessionAt = call.Use(this);
                var meshAt = call.Use(mesh);
                var pairCount = call.Rows(pairs, 2, "pairs");
                var pairsAt = call.Array(pairs);
                var straightMmAt = call.Room(pairCount * 8);
                var geodesicMmAt = call.Room(pairCount * 8);
                call.Check(Functions.mien_measure_lengths(sessionAt, meshAt, pairsAt, (ulong)pairCount, straightMmAt, geodesicMmAt, call.Error));
                return new MeasureLengths(call.ReadDoubles(straightMmAt, pairCount), call.ReadDoubles(geodesicMmAt, pairCount));
            }
        }

        /// <summary>The volume between two surfaces that are not in correspondence, scan to scan: each vertex of before is carried
        /// onto after, then the swept volume is measured. Triangles without a partner do not count.</summary>
        /// <param name="before">#V x 3, mm, with triangles.</param>
        /// <param name="after">another surface with triangles, aligned with before.</param>
        /// <param name="carry">MIEN_CARRY_*.</param>
        /// <param name="direction">3 numbers, any length but zero; may be left out unless carry is MIEN_CARRY_DIRECTION.</param>
        /// <param name="options">may be left out; zones (of before), max_distance_mm (0: 20), limit_of_detection_ml, progress, cancel. Deviations
        /// are not read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH, MIEN_E_NO_SOLUTION
        /// (nothing within reach), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_scan_volume()</remarks>
        public MeasureScanVolume MeasureScanVolume(Mesh before, Mesh after, Carry carry, double[] direction = null, MeasureOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var beforeAt = call.Use(before);
                var afterAt = call.Use(after);
                call.Agree("direction", call.Rows(direction, 1, "direction"), 3);
                var directionAt = call.Array(direction);
                var optionsAt = (options ?? new MeasureOptions()).Write(call, progress, cancellationToken);
                var coverageAt = call.Room(8);
                var outAt = call.Room(8);
                call.Check(Functions.mien_measure_scan_volume(sessionAt, beforeAt, afterAt, (int)carry, directionAt, optionsAt, coverageAt, outAt, call.Error));
                return new MeasureScanVolume(*(double*)coverageAt, call.Keep(new Measurement(call.Pointer(outAt))));
            }
        }

        /// <summary>The volume between two surfaces that are not in correspondence, scan to scan: each vertex of before is carried
        /// onto after, then the swept volume is measured. Triangles without a partner do not count.</summary>
        /// <param name="before">#V x 3, mm, with triangles.</param>
        /// <param name="after">another surface with triangles, aligned with before.</param>
        /// <param name="carry">MIEN_CARRY_*.</param>
        /// <param name="direction">3 numbers, any length but zero; may be left out unless carry is MIEN_CARRY_DIRECTION.</param>
        /// <param name="options">may be left out; zones (of before), max_distance_mm (0: 20), limit_of_detection_ml, progress, cancel. Deviations
        /// are not read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH, MIEN_E_NO_SOLUTION
        /// (nothing within reach), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_scan_volume()</remarks>
        public Task<MeasureScanVolume> MeasureScanVolumeAsync(Mesh before, Mesh after, Carry carry, double[] direction = null, MeasureOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => MeasureScanVolume(before, after, carry, direction, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Moves one face rigidly onto another by a zone that has not changed (forehead, nose bridge), robustly: by
        /// correspondence first, then by closest points, because a fit slides along a scan more than it lifts off. Surfaces
        /// with other triangles (two scans) are brought together by closest points alone and must lie within 15 mm of each
        /// other there. The deviations feed alignment_rotation_sd_rad, alignment_translation_sd_mm and alignment_centre.</summary>
        /// <param name="moving">#V x 3, mm, with triangles.</param>
        /// <param name="target">with triangles.</param>
        /// <param name="stable">may be left out: all vertices. Vertices of target.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH, MIEN_E_NO_SOLUTION (zone
        /// too small or straight), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_measure_align()</remarks>
        public MeasureAlign MeasureAlign(Mesh moving, Mesh target, Zone stable = null)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var movingAt = call.Use(moving);
                var targetAt = call.Use(target);
                var stableAt = call.Record(stable, sizeof(Native.Zone), true, "stable");
                var infoAt = call.Sized(sizeof(Native.ZoneAlignment));
                var outAt = call.Room(8);
                call.Check(Functions.mien_measure_align(sessionAt, movingAt, targetAt, stableAt, infoAt, outAt, call.Error));
                return new MeasureAlign(ZoneAlignment.Read(call, infoAt), call.Keep(new Mesh(call.Pointer(outAt))));
            }
        }

        /// <summary>Compares the left side of a face with the reflection of its right side: volume and distance, signed (positive:
        /// the left side lies farther out), whole and per zone, with intervals. Zones of both sides ("cheek_left",
        /// "cheek_right") are one comparison ("cheek"); of a zone in the middle the left half is compared with the right
        /// half. The result holds volumes, distances, and fields of all vertices (a right vertex against the reflected left
        /// side).</summary>
        /// <param name="face">#V x 3, mm, in the template's topology.</param>
        /// <param name="templateMesh">the template, symmetric about its plane x = 0, +x to the left (mien_model_mesh()).</param>
        /// <param name="options">may be left out: the whole side, no interval.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (plane), MIEN_E_INVALID_MESH (no
        /// triangles; the template is not symmetric), MIEN_E_MISMATCH (vertex counts, zones, landmarks, deviations),
        /// MIEN_E_NO_SOLUTION (no plane is determined), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_asymmetry()</remarks>
        public Measurement MeasureAsymmetry(Mesh face, Mesh templateMesh, AsymmetryOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var faceAt = call.Use(face);
                var templateMeshAt = call.Use(templateMesh);
                var optionsAt = (options ?? new AsymmetryOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_measure_asymmetry(sessionAt, faceAt, templateMeshAt, optionsAt, outAt, call.Error));
                return call.Keep(new Measurement(call.Pointer(outAt)));
            }
        }

        /// <summary>Compares the left side of a face with the reflection of its right side: volume and distance, signed (positive:
        /// the left side lies farther out), whole and per zone, with intervals. Zones of both sides ("cheek_left",
        /// "cheek_right") are one comparison ("cheek"); of a zone in the middle the left half is compared with the right
        /// half. The result holds volumes, distances, and fields of all vertices (a right vertex against the reflected left
        /// side).</summary>
        /// <param name="face">#V x 3, mm, in the template's topology.</param>
        /// <param name="templateMesh">the template, symmetric about its plane x = 0, +x to the left (mien_model_mesh()).</param>
        /// <param name="options">may be left out: the whole side, no interval.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (plane), MIEN_E_INVALID_MESH (no
        /// triangles; the template is not symmetric), MIEN_E_MISMATCH (vertex counts, zones, landmarks, deviations),
        /// MIEN_E_NO_SOLUTION (no plane is determined), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_asymmetry()</remarks>
        public Task<Measurement> MeasureAsymmetryAsync(Mesh face, Mesh templateMesh, AsymmetryOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => MeasureAsymmetry(face, templateMesh, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Splits a face at mode k: the mean moved by its low, and by its high frequencies. low + high - mean is the face.</summary>
        /// <param name="face">#V vertices, mm, aligned with the mean shape.</param>
        /// <param name="k">0 to the basis' modes.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (k), MIEN_E_MISMATCH (vertex count), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_spectral_split()</remarks>
        public SpectralSplit SpectralSplit(SpectralBasis basis, Mesh face, ulong k)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var basisAt = call.Use(basis);
                var faceAt = call.Use(face);
                var lowAt = call.Room(8);
                var highAt = call.Room(8);
                call.Check(Functions.mien_spectral_split(sessionAt, basisAt, faceAt, k, lowAt, highAt, call.Error));
                return new SpectralSplit(call.Keep(new Mesh(call.Pointer(lowAt))), call.Keep(new Mesh(call.Pointer(highAt))));
            }
        }

        /// <summary>The low frequencies of one face with the high frequencies of another.</summary>
        /// <param name="low">#V vertices, mm.</param>
        /// <param name="high">#V vertices, mm.</param>
        /// <param name="k">0 to the basis' modes; #V or more gives `low`.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (k), MIEN_E_MISMATCH (vertex count), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_spectral_assemble()</remarks>
        public Mesh SpectralAssemble(SpectralBasis basis, Mesh low, Mesh high, ulong k)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var basisAt = call.Use(basis);
                var lowAt = call.Use(low);
                var highAt = call.Use(high);
                var outAt = call.Room(8);
                call.Check(Functions.mien_spectral_assemble(sessionAt, basisAt, lowAt, highAt, k, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Multiplies each band of a face by a gain: 0 smooths it away, 1 keeps it, more exaggerates it.</summary>
        /// <param name="face">#V vertices, mm.</param>
        /// <param name="gains">limit_count + 1 finite values.</param>
        /// <param name="limits">limit_count ascending mode numbers</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (limits, gains), MIEN_E_MISMATCH (vertex count), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_spectral_edit()</remarks>
        public Mesh SpectralEdit(SpectralBasis basis, Mesh face, double[] gains, ulong[] limits = null)
        {
            using (var call = new Call())
            {
                call.Required(gains, "gains");
                call.Lock(this);
                var sessionAt = call.Use(this);
                var basisAt = call.Use(basis);
                var faceAt = call.Use(face);
                var limitCount = call.Rows(limits, 1, "limits");
                var limitsAt = call.Array(limits);
                call.Agree("gains", call.Rows(gains, 1, "gains"), limitCount + 1);
                var gainsAt = call.Array(gains);
                var outAt = call.Room(8);
                call.Check(Functions.mien_spectral_edit(sessionAt, basisAt, faceAt, limitsAt, (ulong)limitCount, gainsAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Moves each band of one face towards another's by its own weight; weights 1 and 0 exchange details.</summary>
        /// <param name="first">#V vertices, mm; weight 0.</param>
        /// <param name="second">#V vertices, mm; weight 1.</param>
        /// <param name="weights">limit_count + 1 finite values.</param>
        /// <param name="limits">limit_count ascending mode numbers</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (limits, weights), MIEN_E_MISMATCH (vertex count),
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_spectral_mix()</remarks>
        public Mesh SpectralMix(SpectralBasis basis, Mesh first, Mesh second, double[] weights, ulong[] limits = null)
        {
            using (var call = new Call())
            {
                call.Required(weights, "weights");
                call.Lock(this);
                var sessionAt = call.Use(this);
                var basisAt = call.Use(basis);
                var firstAt = call.Use(first);
                var secondAt = call.Use(second);
                var limitCount = call.Rows(limits, 1, "limits");
                var limitsAt = call.Array(limits);
                call.Agree("weights", call.Rows(weights, 1, "weights"), limitCount + 1);
                var weightsAt = call.Array(weights);
                var outAt = call.Room(8);
                call.Check(Functions.mien_spectral_mix(sessionAt, basisAt, firstAt, secondAt, limitsAt, (ulong)limitCount, weightsAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Spectral coefficients of a face: U' M (face - mean), one row of x, y, z per mode, float64.</summary>
        /// <param name="face">#V vertices, mm, aligned with the mean shape.</param>
        /// <param name="modeCount">0 to the basis' modes: the first of them; more means all.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (vertex count), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_spectral_project()</remarks>
        public double[] SpectralProject(SpectralBasis basis, Mesh face, ulong modeCount)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var basisAt = call.Use(basis);
                var faceAt = call.Use(face);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(3 * 8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 3 * 8);
                } while ((capacity = call.More(Functions.mien_spectral_project(sessionAt, basisAt, faceAt, modeCount, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows * 3);
            }
        }

        /// <summary>The face that has these spectral coefficients: mean + U c. All other modes are zero.</summary>
        /// <param name="firstMode">the mode of the first row.</param>
        /// <param name="coefficients">row_count x 3 row-major float64, finite</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (modes, not finite), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_spectral_synthesize()</remarks>
        public Mesh SpectralSynthesize(SpectralBasis basis, ulong firstMode, double[] coefficients = null)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var basisAt = call.Use(basis);
                var rowCount = call.Rows(coefficients, 3, "coefficients");
                var coefficientsAt = call.Array(coefficients);
                var outAt = call.Room(8);
                call.Check(Functions.mien_spectral_synthesize(sessionAt, basisAt, coefficientsAt, (ulong)rowCount, firstMode, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>A geometric or perceptual distance. L1, L2 and DAME need correspondence, the others do not.</summary>
        /// <param name="metric">MIEN_METRIC_...</param>
        /// <param name="reference">mm.</param>
        /// <param name="other">mm.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (metric), MIEN_E_MISMATCH (vertex
        /// count or triangles), MIEN_E_INVALID_MESH (no triangles), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_metric()</remarks>
        public double Metric(Metric metric, Mesh reference, Mesh other)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var referenceAt = call.Use(reference);
                var otherAt = call.Use(other);
                var valueAt = call.Room(8);
                call.Check(Functions.mien_metric(sessionAt, (int)metric, referenceAt, otherAt, valueAt, call.Error));
                return *(double*)valueAt;
            }
        }

        /// <summary>Where a distance comes from: one value per vertex of the reference. L1: |dx| + |dy| + |dz|; L2: distance of the
        /// two vertices; Hausdorff: of the vertex from the other surface; DAME: masked change of the dihedral angles around
        /// the vertex, rad; FMPD: how much rougher (above 0) or smoother (below 0) the other looks there, after saturation
        /// and masking.</summary>
        /// <param name="metric">MIEN_METRIC_...</param>
        /// <param name="reference">mm.</param>
        /// <param name="other">mm; the reference's triangles, but for Hausdorff.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (metric), MIEN_E_MISMATCH (vertex
        /// count or triangles), MIEN_E_INVALID_MESH (no triangles), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_metric_field()</remarks>
        public double[] MetricField(Metric metric, Mesh reference, Mesh other)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var referenceAt = call.Use(reference);
                var otherAt = call.Use(other);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_metric_field(sessionAt, (int)metric, referenceAt, otherAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows);
            }
        }

        /// <summary>Local roughness of one mesh, what FMPD is made of: the Laplacian of the angle defect, rad, zero at borders.</summary>
        /// <param name="mesh">with triangles.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (no triangles), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_metric_roughness()</remarks>
        public double[] MetricRoughness(Mesh mesh)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var meshAt = call.Use(mesh);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_metric_roughness(sessionAt, meshAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows);
            }
        }

        /// <summary>Carries an expression from one face to another by deformation transfer.</summary>
        /// <param name="sourceNeutral">#V vertices, mm.</param>
        /// <param name="sourceExpression">the same person with the expression.</param>
        /// <param name="targetNeutral">#V vertices, mm; its triangles hold for all.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_MISMATCH (vertex counts), MIEN_E_INVALID_MESH (no triangles), MIEN_E_NO_SOLUTION,
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_transfer_expression()</remarks>
        public Mesh TransferExpression(Mesh sourceNeutral, Mesh sourceExpression, Mesh targetNeutral)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var sourceNeutralAt = call.Use(sourceNeutral);
                var sourceExpressionAt = call.Use(sourceExpression);
                var targetNeutralAt = call.Use(targetNeutral);
                var outAt = call.Room(8);
                call.Check(Functions.mien_transfer_expression(sessionAt, sourceNeutralAt, sourceExpressionAt, targetNeutralAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Fits a model's template to a scan: start, then rounds of closest points, robust weights and a weighted solve
        /// with the model's prior, at falling noise levels; then a smooth field for the rest of the gap. A fit that cannot
        /// be trusted is not an error: ask mien_registration_get_verdict().</summary>
        /// <param name="scan">a surface or a cloud of points, any connectivity, any frame; its unit is detected (options.units), any rotation
        /// is found.</param>
        /// <param name="options">may be left out: no landmarks, all defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (nothing left after cleaning),
        /// MIEN_E_MISMATCH (scan_weights; landmarks whose left and right are exchanged), MIEN_E_NOT_FOUND (start by
        /// landmarks, fewer than three known to the model), MIEN_E_NO_SOLUTION, MIEN_E_UNSUPPORTED_OPTION,
        /// MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED, MIEN_E_CALLBACK</exception>
        /// <remarks>C: mien_register()</remarks>
        public Registration Register(Model model, Mesh scan, RegisterOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var modelAt = call.Use(model);
                var scanAt = call.Use(scan);
                var optionsAt = (options ?? new RegisterOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_register(sessionAt, modelAt, scanAt, optionsAt, outAt, call.Error));
                return call.Keep(new Registration(call.Pointer(outAt)));
            }
        }

        /// <summary>Fits a model's template to a scan: start, then rounds of closest points, robust weights and a weighted solve
        /// with the model's prior, at falling noise levels; then a smooth field for the rest of the gap. A fit that cannot
        /// be trusted is not an error: ask mien_registration_get_verdict().</summary>
        /// <param name="scan">a surface or a cloud of points, any connectivity, any frame; its unit is detected (options.units), any rotation
        /// is found.</param>
        /// <param name="options">may be left out: no landmarks, all defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (nothing left after cleaning),
        /// MIEN_E_MISMATCH (scan_weights; landmarks whose left and right are exchanged), MIEN_E_NOT_FOUND (start by
        /// landmarks, fewer than three known to the model), MIEN_E_NO_SOLUTION, MIEN_E_UNSUPPORTED_OPTION,
        /// MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED, MIEN_E_CALLBACK</exception>
        /// <remarks>C: mien_register()</remarks>
        public Task<Registration> RegisterAsync(Model model, Mesh scan, RegisterOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Register(model, scan, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Carries places (landmarks, points of a contour) from one surface to another in the same frame, e.g. from a
        /// fitted template to the scan under it or back: for each the nearest place on the other surface.</summary>
        /// <param name="surface">where the places go; a mesh or a cloud of points, mm.</param>
        /// <param name="points">#P x 3, F32 or F64, mm.</param>
        /// <param name="maxDistanceMm">farther places are lost (triangle 0xFFFFFFFF); 0: 10, below 0: no limit.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_surface_transfer_points()</remarks>
        public SurfaceTransferPoints SurfaceTransferPoints(Mesh surface, Values points, double maxDistanceMm)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var surfaceAt = call.Use(surface);
                var pointsAt = call.View(points, 3, "points");
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(3 * 8);
                IntPtr trianglesAt;
                IntPtr barycentricAt;
                IntPtr positionsAt;
                do {
                    trianglesAt = call.Room(capacity * 4);
                    barycentricAt = call.Room(capacity * 3 * 8);
                    positionsAt = call.Room(capacity * 3 * 8);
                } while ((capacity = call.More(Functions.mien_surface_transfer_points(sessionAt, surfaceAt, pointsAt, maxDistanceMm, trianglesAt, barycentricAt, positionsAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return new SurfaceTransferPoints(call.ReadUints(trianglesAt, rows), call.ReadDoubles(barycentricAt, rows * 3), call.ReadDoubles(positionsAt, rows * 3));
            }
        }

        /// <summary>Carries a zone from one surface to another in the same frame: the vertices of `to` whose nearest place on `from`
        /// lies in the zone (barycentric share of its vertices at least one half), ascending.</summary>
        /// <param name="from">with the zone's vertices.</param>
        /// <param name="maxDistanceMm">farther vertices stay out; 0: 10, below 0: no limit.</param>
        /// <param name="vertices">vertex_count vertex numbers of `from`</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (a fitted template without triangles),
        /// MIEN_E_MISMATCH (a vertex that `from` does not have), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_surface_transfer_zone()</remarks>
        public uint[] SurfaceTransferZone(Mesh from, Mesh to, double maxDistanceMm, uint[] vertices = null)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var fromAt = call.Use(from);
                var vertexCount = call.Rows(vertices, 1, "vertices");
                var verticesAt = call.Array(vertices);
                var toAt = call.Use(to);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(4);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 4);
                } while ((capacity = call.More(Functions.mien_surface_transfer_zone(sessionAt, fromAt, verticesAt, (ulong)vertexCount, toAt, maxDistanceMm, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadUints(dstAt, rows);
            }
        }

        /// <summary>A model's landmarks or zones, carried from its fitted template to a scan, as JSON text in the form of the
        /// landmark and zone files: {"points": {name: [x, y, z]}, "distances_mm": {name: d}} or {"zones": {name: [scan
        /// vertex, ...]}}.</summary>
        /// <param name="model">whose landmarks and zones are meant.</param>
        /// <param name="fitted">the model's template after registration.</param>
        /// <param name="scan">in the frame of fitted, mm.</param>
        /// <param name="what">MIEN_TRANSFER_LANDMARKS or MIEN_TRANSFER_ZONES.</param>
        /// <param name="maxDistanceMm">farther places are left out; 0: 10, below 0: no limit.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (what), MIEN_E_MISMATCH (fitted is not
        /// of the model), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_surface_transfer_json()</remarks>
        public string SurfaceTransferJson(Model model, Mesh fitted, Mesh scan, Transfer what, double maxDistanceMm)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var modelAt = call.Use(model);
                var fittedAt = call.Use(fitted);
                var scanAt = call.Use(scan);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_surface_transfer_json(sessionAt, modelAt, fittedAt, scanAt, (int)what, maxDistanceMm, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>mien_neutralize_mesh() of a registered face: its weights say where the scan had data, its pose is that of the
        /// scan. options.weights, where given, replace the registration's.</summary>
        /// <param name="fitted">registered with the template of the model's training faces.</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">as mien_neutralize_mesh()</exception>
        /// <remarks>C: mien_neutralize()</remarks>
        public Neutralization Neutralize(ExpressionModel model, Registration fitted, NeutralizeOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var modelAt = call.Use(model);
                var fittedAt = call.Use(fitted);
                var optionsAt = (options ?? new NeutralizeOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_neutralize(sessionAt, modelAt, fittedAt, optionsAt, outAt, call.Error));
                return call.Keep(new Neutralization(call.Pointer(outAt)));
            }
        }

        /// <summary>mien_neutralize_mesh() of a registered face: its weights say where the scan had data, its pose is that of the
        /// scan. options.weights, where given, replace the registration's.</summary>
        /// <param name="fitted">registered with the template of the model's training faces.</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">as mien_neutralize_mesh()</exception>
        /// <remarks>C: mien_neutralize()</remarks>
        public Task<Neutralization> NeutralizeAsync(ExpressionModel model, Registration fitted, NeutralizeOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Neutralize(model, fitted, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Takes the expression off a face and keeps everything that the model does not explain.</summary>
        /// <param name="face">in the model's topology, or in a larger one that begins with it (there the displacement runs out smoothly behind
        /// the model's rim); mm.</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a switch or an enumerator that this
        /// library does not know), MIEN_E_MISMATCH (topology, weights), MIEN_E_NO_SOLUTION (MIEN_FIT_EXACT with too little
        /// of the face visible), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_neutralize_mesh()</remarks>
        public Neutralization NeutralizeMesh(ExpressionModel model, Mesh face, NeutralizeOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var modelAt = call.Use(model);
                var faceAt = call.Use(face);
                var optionsAt = (options ?? new NeutralizeOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_neutralize_mesh(sessionAt, modelAt, faceAt, optionsAt, outAt, call.Error));
                return call.Keep(new Neutralization(call.Pointer(outAt)));
            }
        }

        /// <summary>Takes the expression off a face and keeps everything that the model does not explain.</summary>
        /// <param name="face">in the model's topology, or in a larger one that begins with it (there the displacement runs out smoothly behind
        /// the model's rim); mm.</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a switch or an enumerator that this
        /// library does not know), MIEN_E_MISMATCH (topology, weights), MIEN_E_NO_SOLUTION (MIEN_FIT_EXACT with too little
        /// of the face visible), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_neutralize_mesh()</remarks>
        public Task<Neutralization> NeutralizeMeshAsync(ExpressionModel model, Mesh face, NeutralizeOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => NeutralizeMesh(model, face, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Neutralizes every face of a dataset whose subject has a neutral face, and compares.</summary>
        /// <param name="model">in the dataset's topology.</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a fit that this library does not
        /// know), MIEN_E_MISMATCH, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_evaluate_neutralization()</remarks>
        public Evaluation EvaluateNeutralization(ExpressionModel model, string datasetPath, EvaluateOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var modelAt = call.Use(model);
                var datasetPathAt = call.Text(datasetPath);
                var optionsAt = (options ?? new EvaluateOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_evaluate_neutralization(sessionAt, modelAt, datasetPathAt, optionsAt, outAt, call.Error));
                return call.Keep(new Evaluation(call.Pointer(outAt)));
            }
        }

        /// <summary>Neutralizes every face of a dataset whose subject has a neutral face, and compares.</summary>
        /// <param name="model">in the dataset's topology.</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a fit that this library does not
        /// know), MIEN_E_MISMATCH, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_evaluate_neutralization()</remarks>
        public Task<Evaluation> EvaluateNeutralizationAsync(ExpressionModel model, string datasetPath, EvaluateOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => EvaluateNeutralization(model, datasetPath, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Distance of every vertex from the nearest of some vertices, along the surface, by the heat method; a model's
        /// template is a mesh too (mien_model_mesh()). Holes are gone around, edges are not followed.</summary>
        /// <param name="mesh">#V x 3, mm, with triangles.</param>
        /// <param name="sources">source_count vertex numbers.</param>
        /// <param name="options">may be left out: heat stays inside, a time of 4 mean edges squared.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_UNSUPPORTED_OPTION,
        /// MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_geodesic()</remarks>
        public double[] MeasureGeodesic(Mesh mesh, uint[] sources, GeodesicOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Required(sources, "sources");
                call.Lock(this);
                var sessionAt = call.Use(this);
                var meshAt = call.Use(mesh);
                var sourceCount = call.Rows(sources, 1, "sources");
                var sourcesAt = call.Array(sources);
                var optionsAt = (options ?? new GeodesicOptions()).Write(call, progress, cancellationToken);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_measure_geodesic(sessionAt, meshAt, sourcesAt, (ulong)sourceCount, optionsAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows);
            }
        }

        /// <summary>Distance of every vertex from the nearest of some vertices, along the surface, by the heat method; a model's
        /// template is a mesh too (mien_model_mesh()). Holes are gone around, edges are not followed.</summary>
        /// <param name="mesh">#V x 3, mm, with triangles.</param>
        /// <param name="sources">source_count vertex numbers.</param>
        /// <param name="options">may be left out: heat stays inside, a time of 4 mean edges squared.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_UNSUPPORTED_OPTION,
        /// MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_measure_geodesic()</remarks>
        public Task<double[]> MeasureGeodesicAsync(Mesh mesh, uint[] sources, GeodesicOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => MeasureGeodesic(mesh, sources, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>How far raters (or one rater's sessions) agree, as JSON: confusion matrices, percent agreement, Cohen's kappa
        /// plain, linear and quadratic, Fleiss' kappa, all six intraclass correlations, majority grades.</summary>
        /// <param name="ratings">subject_count x rater_count, 0 .. grade_count - 1, negative: missing.</param>
        /// <param name="raterCount">2 to 1000.</param>
        /// <param name="gradeCount">2 to 1000.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (grades, no subject graded by all), MIEN_E_BUFFER_TOO_SMALL,
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_statistics_agreement()</remarks>
        public string StatisticsAgreement(int[] ratings, uint raterCount, int gradeCount)
        {
            using (var call = new Call())
            {
                call.Required(ratings, "ratings");
                call.Lock(this);
                var sessionAt = call.Use(this);
                var subjectCount = call.Rows(ratings, (long) raterCount, "ratings");
                var ratingsAt = call.Array(ratings);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_statistics_agreement(sessionAt, ratingsAt, (ulong)subjectCount, raterCount, gradeCount, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>Within-subject deviation and repeatability coefficient of repeated captures, and the limit of detection from
        /// changes measured where nothing changed, as JSON.</summary>
        /// <param name="subjects">value_count numbers: who was measured.</param>
        /// <param name="values">value_count values</param>
        /// <param name="blanks">blank_count changes measured without any true one; may be left out when 0.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_statistics_repeatability()</remarks>
        public string StatisticsRepeatability(int[] subjects, double[] values = null, double[] blanks = null)
        {
            using (var call = new Call())
            {
                call.Required(subjects, "subjects");
                call.Lock(this);
                var sessionAt = call.Use(this);
                var valueCount = call.Rows(values, 1, "values");
                var valuesAt = call.Array(values);
                call.Agree("subjects", call.Rows(subjects, 1, "subjects"), valueCount);
                var subjectsAt = call.Array(subjects);
                var blankCount = call.Rows(blanks, 1, "blanks");
                var blanksAt = call.Array(blanks);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_statistics_repeatability(sessionAt, valuesAt, subjectsAt, (ulong)valueCount, blanksAt, (ulong)blankCount, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>Bland and Altman's comparison of two methods on the same subjects, as JSON: bias, limits of agreement, their
        /// intervals, and whether the bias grows with the size.</summary>
        /// <param name="first">value_count values.</param>
        /// <param name="second">value_count values.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_statistics_bland_altman()</remarks>
        public string StatisticsBlandAltman(double[] first, double[] second)
        {
            using (var call = new Call())
            {
                call.Required(second, "second");
                call.Required(first, "first");
                call.Lock(this);
                var sessionAt = call.Use(this);
                var valueCount = call.Rows(first, 1, "first");
                var firstAt = call.Array(first);
                call.Agree("second", call.Rows(second, 1, "second"), valueCount);
                var secondAt = call.Array(second);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_statistics_bland_altman(sessionAt, firstAt, secondAt, (ulong)valueCount, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>Neutralizes several scans of one person together: one identity, an expression each.</summary>
        /// <param name="faces">face_count faces in one topology: the model's, or a larger one that begins with it (there the displacement runs
        /// out smoothly behind the model's rim).</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">as mien_neutralize_mesh()</exception>
        /// <remarks>C: mien_neutralize_series()</remarks>
        public Series NeutralizeSeries(ExpressionModel model, IReadOnlyList<Mesh> faces, SeriesOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Required(faces, "faces");
                call.Lock(this);
                var sessionAt = call.Use(this);
                var modelAt = call.Use(model);
                var faceCount = call.Rows(faces, 1, "faces");
                var facesAt = call.Handles(faces);
                var optionsAt = (options ?? new SeriesOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_neutralize_series(sessionAt, modelAt, facesAt, (uint)faceCount, optionsAt, outAt, call.Error));
                return call.Keep(new Series(call.Pointer(outAt)));
            }
        }

        /// <summary>Neutralizes several scans of one person together: one identity, an expression each.</summary>
        /// <param name="faces">face_count faces in one topology: the model's, or a larger one that begins with it (there the displacement runs
        /// out smoothly behind the model's rim).</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">as mien_neutralize_mesh()</exception>
        /// <remarks>C: mien_neutralize_series()</remarks>
        public Task<Series> NeutralizeSeriesAsync(ExpressionModel model, IReadOnlyList<Mesh> faces, SeriesOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => NeutralizeSeries(model, faces, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Looks for what makes a mesh a bad template: size and unit (a face, head or bust in mm), windings (inside out, or
        /// mixed), helpers and other pieces, degenerate and doubled parts, symmetry, and, where landmarks of the 68-point
        /// scheme are given, pose, left and right, closed eyes and mouth. The findings come as JSON text by the two-call
        /// protocol: {"errors": n, "warnings": n, "findings": [{"kind": "error" or "warning", "code", "text", "vertices":
        /// [...]}]}. No model should be built from a mesh with errors; mien_model_build() does not ask.</summary>
        /// <param name="templateMesh">the mesh as it is given to mien_model_build().</param>
        /// <param name="mirror">1: symmetry about x = 0 is asked for, as by options.mirror_symmetric; 0.</param>
        /// <param name="landmarks">may be left out; vertices of the mesh.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (a landmark that is no vertex of the mesh),
        /// MIEN_E_UNSUPPORTED_OPTION (mirror), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_template_check()</remarks>
        public string TemplateCheck(Mesh templateMesh, int mirror, Landmarks landmarks = null)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var templateMeshAt = call.Use(templateMesh);
                var landmarksAt = call.UseOrNull(landmarks);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_template_check(sessionAt, templateMeshAt, landmarksAt, mirror, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>Writes a shard: what a part of a dataset contributes to training, for a cluster's scheduler. Parts are made by
        /// subject, every part_count-th of the sorted subject numbers.</summary>
        /// <param name="shardPath">written atomically.</param>
        /// <param name="options">may be left out: the whole dataset.</param>
        /// <exception cref="MienException">as mien_expression_model_train(); MIEN_E_INVALID_ARGUMENT for a part that does not exist or is empty</exception>
        /// <remarks>C: mien_expression_shard_create()</remarks>
        public void ExpressionShardCreate(string datasetPath, string shardPath, ShardOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var sessionAt = call.Use(this);
                var datasetPathAt = call.Text(datasetPath);
                var optionsAt = (options ?? new ShardOptions()).Write(call, progress, cancellationToken);
                var shardPathAt = call.Text(shardPath);
                call.Check(Functions.mien_expression_shard_create(sessionAt, datasetPathAt, optionsAt, shardPathAt, call.Error));
            }
        }

        /// <summary>Writes a shard: what a part of a dataset contributes to training, for a cluster's scheduler. Parts are made by
        /// subject, every part_count-th of the sorted subject numbers.</summary>
        /// <param name="shardPath">written atomically.</param>
        /// <param name="options">may be left out: the whole dataset.</param>
        /// <exception cref="MienException">as mien_expression_model_train(); MIEN_E_INVALID_ARGUMENT for a part that does not exist or is empty</exception>
        /// <remarks>C: mien_expression_shard_create()</remarks>
        public Task ExpressionShardCreateAsync(string datasetPath, string shardPath, ShardOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => ExpressionShardCreate(datasetPath, shardPath, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Takes the expressions off faces of one person, first visit first, so that the neutral faces are in
        /// correspondence along the skin and differ by what changed. The right road to a volume over time: fitted templates
        /// slide along the skin, and mien_neutralize() takes a part of the slide for expression.</summary>
        /// <param name="faces">face_count fitted faces, mm, in one topology: the model's, or a larger one that begins with it (there the
        /// displacement runs out smoothly behind the model's rim).</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a pose that this library does not
        /// know), MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (topology, weights, treated vertices), MIEN_E_NO_SOLUTION,
        /// MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_neutralize_visits()</remarks>
        public Visits NeutralizeVisits(ExpressionModel model, IReadOnlyList<Mesh> faces, VisitsOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Required(faces, "faces");
                call.Lock(this);
                var sessionAt = call.Use(this);
                var modelAt = call.Use(model);
                var faceCount = call.Rows(faces, 1, "faces");
                var facesAt = call.Handles(faces);
                var optionsAt = (options ?? new VisitsOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_neutralize_visits(sessionAt, modelAt, facesAt, (uint)faceCount, optionsAt, outAt, call.Error));
                return call.Keep(new Visits(call.Pointer(outAt)));
            }
        }

        /// <summary>Takes the expressions off faces of one person, first visit first, so that the neutral faces are in
        /// correspondence along the skin and differ by what changed. The right road to a volume over time: fitted templates
        /// slide along the skin, and mien_neutralize() takes a part of the slide for expression.</summary>
        /// <param name="faces">face_count fitted faces, mm, in one topology: the model's, or a larger one that begins with it (there the
        /// displacement runs out smoothly behind the model's rim).</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a pose that this library does not
        /// know), MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (topology, weights, treated vertices), MIEN_E_NO_SOLUTION,
        /// MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_neutralize_visits()</remarks>
        public Task<Visits> NeutralizeVisitsAsync(ExpressionModel model, IReadOnlyList<Mesh> faces, VisitsOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => NeutralizeVisits(model, faces, options, progress, cancellationToken), cancellationToken);
        }
    }

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

    /// <summary>A triangle mesh or point cloud, checked: finite coordinates, indices in range. Millimetres. Immutable: share
    /// freely between threads.</summary>
    public sealed unsafe class Mesh : NativeObject
    {
        internal Mesh(IntPtr owned) : base(owned, at => Functions.mien_mesh_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public Mesh Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_mesh_retain(at);
                return new Mesh(at);
            }
        }

        /// <summary>Makes a mesh from the host's arrays, which are copied.</summary>
        /// <param name="arrays">see the fields for shapes and units.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_ARGUMENT (null, misaligned, stride, dtype), MIEN_E_INVALID_MESH (no vertex, value not finite,
        /// index out of range), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_mesh_create()</remarks>
        public static Mesh Create(Session session, MeshArrays arrays)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var arraysAt = call.Record(arrays, sizeof(Native.MeshArrays), false, "arrays");
                var outAt = call.Room(8);
                call.Check(Functions.mien_mesh_create(sessionAt, arraysAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Reads a mesh file: see mien_mesh_format_extension(). What the file holds tells its format, its name only where
        /// that leaves it open. Polygons become triangle fans; colours, texture coordinates, materials and images (of this
        /// file and beside it) are kept. Points that are not numbers and part of no triangle are dropped, with a warning in
        /// the session's log. The file is treated as hostile.</summary>
        /// <exception cref="MienException">MIEN_E_IO, MIEN_E_INVALID_ARGUMENT (unknown extension), MIEN_E_BAD_FORMAT, MIEN_E_INVALID_MESH,
        /// MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_mesh_load()</remarks>
        public static Mesh Load(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_mesh_load(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Writes a mesh file by extension: see mien_mesh_format_writes(). Coordinates are float32 or nine digits where
        /// that steps by at most 0.001 mm, else double; STL, which cannot, is refused then. Materials and images are
        /// written beside OBJ and PLY files and into GLB files, each image's bytes as they were read. Atomic: a full disk
        /// or a crash leaves an old file whole.</summary>
        /// <exception cref="MienException">MIEN_E_IO, MIEN_E_INVALID_ARGUMENT (unknown extension, a format that is read only), MIEN_E_INVALID_MESH (STL far
        /// from the origin), MIEN_E_UNSUPPORTED_OPTION (pixels, in a build without image coders), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_mesh_save()</remarks>
        public void Save(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var meshAt = call.Use(this);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_mesh_save(sessionAt, meshAt, pathAt, call.Error));
            }
        }

        /// <summary>Numbers of vertices and triangles.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_mesh_get_counts()</remarks>
        public MeshCounts GetCounts()
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var vertexCountAt = call.Room(8);
                var triangleCountAt = call.Room(8);
                call.Check(Functions.mien_mesh_get_counts(meshAt, vertexCountAt, triangleCountAt, call.Error));
                return new MeshCounts(*(ulong*)vertexCountAt, *(ulong*)triangleCountAt);
            }
        }

        /// <summary>Copies the positions, #V x 3 tightly packed, mm. With dst null and capacity 0: writes the count only.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_mesh_get_positions()</remarks>
        public double[] GetPositions()
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(3 * 8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 3 * 8);
                } while ((capacity = call.More(Functions.mien_mesh_get_positions(meshAt, 2, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows * 3);
            }
        }

        /// <summary>Copies the positions, #V x 3 tightly packed, mm. With dst null and capacity 0: writes the count only.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_mesh_get_positions()</remarks>
        public float[] GetPositionsF32()
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(3 * 4);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 3 * 4);
                } while ((capacity = call.More(Functions.mien_mesh_get_positions(meshAt, 1, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadFloats(dstAt, rows * 3);
            }
        }

        /// <summary>Copies the triangles, #F x 3 uint32 tightly packed.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_mesh_get_triangles()</remarks>
        public uint[] GetTriangles()
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(3 * 4);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 3 * 4);
                } while ((capacity = call.More(Functions.mien_mesh_get_triangles(meshAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadUints(dstAt, rows * 3);
            }
        }

        /// <summary>Copies the vertex colours, #V x 3 uint8; the count is 0 when the mesh has none.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_mesh_get_colors()</remarks>
        public byte[] GetColors()
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(3);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 3);
                } while ((capacity = call.More(Functions.mien_mesh_get_colors(meshAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadBytes(dstAt, rows * 3);
            }
        }

        /// <summary>The number of mesh formats, counted by file extension.</summary>
        /// <remarks>C: mien_mesh_format_count()</remarks>
        public static uint FormatCount()
        {
            using (var call = new Call())
            {
                return Functions.mien_mesh_format_count();
            }
        }

        /// <summary>The extension of a mesh format: lower case, without its dot, e.g. "ply".</summary>
        /// <param name="format">0 to mien_mesh_format_count() - 1; null is returned for others.</param>
        /// <remarks>C: mien_mesh_format_extension()</remarks>
        public static string FormatExtension(uint format)
        {
            using (var call = new Call())
            {
                return Text.FromNative(Functions.mien_mesh_format_extension(format));
            }
        }

        /// <summary>What a mesh format is called, for people, e.g. "Stanford PLY".</summary>
        /// <param name="format">0 to mien_mesh_format_count() - 1; null is returned for others.</param>
        /// <remarks>C: mien_mesh_format_description()</remarks>
        public static string FormatDescription(uint format)
        {
            using (var call = new Call())
            {
                return Text.FromNative(Functions.mien_mesh_format_description(format));
            }
        }

        /// <summary>1 for a format that mien_mesh_save() writes, 0 for one that is only read.</summary>
        /// <param name="format">0 to mien_mesh_format_count() - 1; 0 is returned for others.</param>
        /// <remarks>C: mien_mesh_format_writes()</remarks>
        public static int FormatWrites(uint format)
        {
            using (var call = new Call())
            {
                return Functions.mien_mesh_format_writes(format);
            }
        }

        /// <summary>Copies the texture coordinates, #T x 2 float32: (0, 0) is the lower left corner of the image, (1, 1) the upper
        /// right. The count is 0 when the mesh has none.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_mesh_get_texture()</remarks>
        public float[] GetTexture()
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(2 * 4);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 2 * 4);
                } while ((capacity = call.More(Functions.mien_mesh_get_texture(meshAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadFloats(dstAt, rows * 2);
            }
        }

        /// <summary>Copies for each corner of each triangle the number of its texture coordinate, #F x 3 uint32. The count is 0 when
        /// the mesh has none.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_mesh_get_texture_triangles()</remarks>
        public uint[] GetTextureTriangles()
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(3 * 4);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 3 * 4);
                } while ((capacity = call.More(Functions.mien_mesh_get_texture_triangles(meshAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadUints(dstAt, rows * 3);
            }
        }

        /// <summary>Copies the number of each triangle's material, #F uint32. The count is 0 when the mesh has no material, or a
        /// single one that all triangles have.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_mesh_get_triangle_materials()</remarks>
        public uint[] GetTriangleMaterials()
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(4);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 4);
                } while ((capacity = call.More(Functions.mien_mesh_get_triangle_materials(meshAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadUints(dstAt, rows);
            }
        }

        /// <summary>Numbers of materials and of images.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_mesh_get_material_counts()</remarks>
        public MeshMaterialCounts GetMaterialCounts()
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var materialCountAt = call.Room(8);
                var imageCountAt = call.Room(8);
                call.Check(Functions.mien_mesh_get_material_counts(meshAt, materialCountAt, imageCountAt, call.Error));
                return new MeshMaterialCounts(*(ulong*)materialCountAt, *(ulong*)imageCountAt);
            }
        }

        /// <summary>A material: its base colour and the number of its base colour's image.</summary>
        /// <param name="material">0 to the number of materials - 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such material)</exception>
        /// <remarks>C: mien_mesh_get_material()</remarks>
        public MeshMaterial GetMaterial(ulong material)
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var imageAt = call.Room(8);
                var redAt = call.Room(8);
                var greenAt = call.Room(8);
                var blueAt = call.Room(8);
                call.Check(Functions.mien_mesh_get_material(meshAt, material, imageAt, redAt, greenAt, blueAt, call.Error));
                return new MeshMaterial(*(int*)imageAt, *(double*)redAt, *(double*)greenAt, *(double*)blueAt);
            }
        }

        /// <summary>Copies a material's name, UTF-8 with its terminating zero.</summary>
        /// <param name="material">0 to the number of materials - 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such material)</exception>
        /// <remarks>C: mien_mesh_get_material_name()</remarks>
        public string GetMaterialName(ulong material)
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_mesh_get_material_name(meshAt, material, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>Copies an image's file name without a folder, UTF-8 with its terminating zero.</summary>
        /// <param name="image">0 to the number of images - 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such image)</exception>
        /// <remarks>C: mien_mesh_get_image_name()</remarks>
        public string GetImageName(ulong image)
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_mesh_get_image_name(meshAt, image, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>Copies the bytes of an image's file as they were read. The count is 0 for pixels of a host's.</summary>
        /// <param name="image">0 to the number of images - 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such image)</exception>
        /// <remarks>C: mien_mesh_get_image_file()</remarks>
        public byte[] GetImageFile(ulong image)
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_mesh_get_image_file(meshAt, image, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadBytes(dstAt, rows);
            }
        }

        /// <summary>The width and height of an image in pixels, from its header.</summary>
        /// <param name="image">0 to the number of images - 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such image), MIEN_E_BAD_FORMAT (damaged),
        /// MIEN_E_UNSUPPORTED_OPTION (neither JPEG nor PNG, or above 134 million pixels)</exception>
        /// <remarks>C: mien_mesh_get_image_size()</remarks>
        public MeshImageSize GetImageSize(ulong image)
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var widthAt = call.Room(8);
                var heightAt = call.Room(8);
                call.Check(Functions.mien_mesh_get_image_size(meshAt, image, widthAt, heightAt, call.Error));
                return new MeshImageSize(*(uint*)widthAt, *(uint*)heightAt);
            }
        }

        /// <summary>Decodes an image into height rows of width x 3 red green blue bytes, from the top.</summary>
        /// <param name="image">0 to the number of images - 1.</param>
        /// <param name="rowStrideBytes">bytes from row to row of dst, at least 3 * width; 0: tightly packed.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no such image, stride below a row), MIEN_E_BAD_FORMAT (damaged),
        /// MIEN_E_UNSUPPORTED_OPTION (another kind, or a build without image decoders), MIEN_E_MEMORY_BUDGET,
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_mesh_get_image_pixels()</remarks>
        public byte[] GetImagePixels(Session session, ulong image, ulong rowStrideBytes)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var meshAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_mesh_get_image_pixels(sessionAt, meshAt, image, rowStrideBytes, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadBytes(dstAt, rows);
            }
        }

        /// <summary>Writes a GLB file of a mesh and named changes of it (glTF's morph targets): an expression model's blendshapes in
        /// one file. Each target is the whole changed mesh, with the vertices of `mesh`.</summary>
        /// <param name="targets">target_count meshes, unless target_count is 0.</param>
        /// <param name="names">target_count UTF-8 names, unless target_count is 0.</param>
        /// <param name="path">ends with .glb.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (another extension), MIEN_E_MISMATCH (vertex counts), MIEN_E_IO,
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_mesh_save_targets()</remarks>
        public void SaveTargets(Session session, IReadOnlyList<Mesh> targets, IReadOnlyList<string> names, string path)
        {
            using (var call = new Call())
            {
                call.Required(names, "names");
                call.Required(targets, "targets");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var meshAt = call.Use(this);
                var targetCount = call.Rows(targets, 1, "targets");
                var targetsAt = call.Handles(targets);
                call.Agree("names", call.Rows(names, 1, "names"), targetCount);
                var namesAt = call.Texts(names);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_mesh_save_targets(sessionAt, meshAt, targetsAt, namesAt, (ulong)targetCount, pathAt, call.Error));
            }
        }

        /// <summary>Reads a glTF file with one of its morph targets at full weight.</summary>
        /// <param name="path">.glb or .gltf.</param>
        /// <param name="name">UTF-8 name of the target</param>
        /// <exception cref="MienException">MIEN_E_NOT_FOUND (no such target; the message names some), otherwise as mien_mesh_load()</exception>
        /// <remarks>C: mien_mesh_load_target()</remarks>
        public static Mesh LoadTarget(Session session, string path, string name)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var nameAt = call.Text(name);
                var outAt = call.Room(8);
                call.Check(Functions.mien_mesh_load_target(sessionAt, pathAt, nameAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>The positions in place: *data points to #V x 3 float64, tightly packed, mm.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_mesh_positions_view()</remarks>
        public ReadOnlyMemory<double> GetPositionsView()
        {
            using (var call = new Call())
            {
                var meshAt = call.Use(this);
                var dataAt = call.Room(8);
                var countAt = call.Room(8);
                call.Check(Functions.mien_mesh_positions_view(meshAt, dataAt, countAt, call.Error));
                var rows = call.Count(countAt);
                return call.Lend<double>(*(IntPtr*)dataAt, rows * 3, this);
            }
        }

        /// <summary>What a mesh is and what is wrong with it, as JSON text: counts, box, extent and the units in which that is a
        /// face, a head or a body, pieces, borders, windings, doubled and unused parts, and "faults": a list of sentences
        /// that say what is wrong and what to do.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_mesh_inspect()</remarks>
        public string Inspect(Session session)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var meshAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_mesh_inspect(sessionAt, meshAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>Merges vertices of equal coordinates, drops degenerate, doubled and unused parts and pieces of fewer than
        /// min_triangles triangles, and winds all triangles of a piece alike. Order and coordinates of what stays are kept.</summary>
        /// <param name="minTriangles">0: all pieces stay.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_mesh_clean()</remarks>
        public Mesh Clean(Session session, ulong minTriangles)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var meshAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_mesh_clean(sessionAt, meshAt, minTriangles, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Moves every vertex by a row-major 4 x 4 matrix: scales, turns, shifts. When it mirrors (negative determinant),
        /// the triangles are wound the other way, so that outside stays outside.</summary>
        /// <param name="matrix">16 values, last row 0 0 0 1, invertible.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_mesh_transform()</remarks>
        public Mesh Transform(Session session, double[] matrix)
        {
            using (var call = new Call())
            {
                call.Required(matrix, "matrix");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var meshAt = call.Use(this);
                call.Agree("matrix", call.Rows(matrix, 1, "matrix"), 16);
                var matrixAt = call.Array(matrix);
                var outAt = call.Room(8);
                call.Check(Functions.mien_mesh_transform(sessionAt, meshAt, matrixAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Winds every triangle the other way: inside becomes outside.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_mesh_turn_over()</remarks>
        public Mesh TurnOver(Session session)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var meshAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_mesh_turn_over(sessionAt, meshAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Collapses edges of least quadric error until vertex_count vertices are left or no collapse is legal. Every
        /// vertex that stays is one of the input with its place and colour; texture coordinates are dropped. Vertices in
        /// which fans of triangles merely touch are split first; triangles that fit into no manifold go.</summary>
        /// <param name="vertexCount">at least 4.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_mesh_decimate()</remarks>
        public Mesh Decimate(Session session, ulong vertexCount)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var meshAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_mesh_decimate(sessionAt, meshAt, vertexCount, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Fails when one of two meshes of the same face is so many times larger that they cannot be in one unit (7 times;
        /// mm and cm differ by 10). The message names the unit that would explain it.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_MISMATCH (not in one unit), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_mesh_check_same_unit()</remarks>
        public void CheckSameUnit(Mesh second)
        {
            using (var call = new Call())
            {
                var firstAt = call.Use(this);
                var secondAt = call.Use(second);
                call.Check(Functions.mien_mesh_check_same_unit(firstAt, secondAt, call.Error));
            }
        }
    }

    /// <summary>A template with its modes of deformation: u(x) = mean(x) + sum_j basis_j(x) a_j + sum_k mode_k(x) c_k, a and c
    /// standard normal; basis_j are scalar and serve x, y and z, mode_k come from faces. Built or loaded once.
    /// Immutable: share freely between threads.</summary>
    public sealed unsafe class Model : NativeObject
    {
        internal Model(IntPtr owned) : base(owned, at => Functions.mien_model_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public Model Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_model_retain(at);
                return new Model(at);
            }
        }

        /// <summary>Builds a deformation model: control points, kernel columns, low-rank basis; with a dataset also the mean and the
        /// principal modes of its faces.</summary>
        /// <param name="templateMesh">#V x 3, mm, with triangles for the surface kernels.</param>
        /// <param name="options">may be left out: geodesic kernel of 20 mm, 999 modes.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (no triangles, not symmetric),
        /// MIEN_E_MISMATCH (scales, dataset), MIEN_E_UNSUPPORTED_OPTION, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
        /// MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_model_build()</remarks>
        public static Model Build(Session session, Mesh templateMesh, ModelOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var templateMeshAt = call.Use(templateMesh);
                var optionsAt = (options ?? new ModelOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_model_build(sessionAt, templateMeshAt, optionsAt, outAt, call.Error));
                return call.Keep(new Model(call.Pointer(outAt)));
            }
        }

        /// <summary>Builds a deformation model: control points, kernel columns, low-rank basis; with a dataset also the mean and the
        /// principal modes of its faces.</summary>
        /// <param name="templateMesh">#V x 3, mm, with triangles for the surface kernels.</param>
        /// <param name="options">may be left out: geodesic kernel of 20 mm, 999 modes.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (no triangles, not symmetric),
        /// MIEN_E_MISMATCH (scales, dataset), MIEN_E_UNSUPPORTED_OPTION, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
        /// MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_model_build()</remarks>
        public static Task<Model> BuildAsync(Session session, Mesh templateMesh, ModelOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Build(session, templateMesh, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Loads a model file through a memory map and checks all of it: structure, hash, finite values.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_WRONG_KIND,
        /// MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_MESH, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_model_load()</remarks>
        public static Model Load(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_model_load(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new Model(call.Pointer(outAt)));
            }
        }

        /// <summary>Loads a model from the bytes of a model file that the host holds in memory, e.g. as a resource of its program.
        /// They are copied and checked like a file.</summary>
        /// <param name="data">size bytes, any alignment; not read after the call.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_WRONG_KIND,
        /// MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_model_load_memory()</remarks>
        public static Model LoadMemory(Session session, byte[] data)
        {
            using (var call = new Call())
            {
                call.Required(data, "data");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var size = call.Rows(data, 1, "data");
                var dataAt = call.Array(data);
                var outAt = call.Room(8);
                call.Check(Functions.mien_model_load_memory(sessionAt, dataAt, (ulong)size, outAt, call.Error));
                return call.Keep(new Model(call.Pointer(outAt)));
            }
        }

        /// <summary>Loads a model file that the host trusts: its structure is checked, its hash and values are not.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION,
        /// MIEN_E_INVALID_MESH, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_model_load_trusted()</remarks>
        public static Model LoadTrusted(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_model_load_trusted(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new Model(call.Pointer(outAt)));
            }
        }

        /// <summary>Writes a model file (safetensors). Atomic: a full disk or a crash leaves an old file whole.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_model_save()</remarks>
        public void Save(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_model_save(sessionAt, modelAt, pathAt, call.Error));
            }
        }

        /// <summary>Numbers of vertices and modes.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_model_get_counts()</remarks>
        public ModelCounts GetCounts()
        {
            using (var call = new Call())
            {
                var modelAt = call.Use(this);
                var vertexCountAt = call.Room(8);
                var scalarModesAt = call.Room(8);
                var vectorModesAt = call.Room(8);
                call.Check(Functions.mien_model_get_counts(modelAt, vertexCountAt, scalarModesAt, vectorModesAt, call.Error));
                return new ModelCounts(*(ulong*)vertexCountAt, *(ulong*)scalarModesAt, *(ulong*)vectorModesAt);
            }
        }

        /// <summary>What the model is: counts, kernel and its settings, rank, variance explained, largest pointwise variance error,
        /// clipped negative mass, names of landmarks and zones. As JSON text by the two-call protocol.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_model_get_json()</remarks>
        public string GetJson()
        {
            using (var call = new Call())
            {
                var modelAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_model_get_json(modelAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>Prior variance of each coordinate of each vertex, #V x 3 float64, mm^2, modes of both kinds together.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_model_get_variance()</remarks>
        public double[] GetVariance()
        {
            using (var call = new Call())
            {
                var modelAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(3 * 8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 3 * 8);
                } while ((capacity = call.More(Functions.mien_model_get_variance(modelAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows * 3);
            }
        }

        /// <summary>A random face: the template moved by the mean and `strength` times a draw from the prior. Face `index` of `seed`
        /// is the same whatever else was drawn; strength 0 gives the mean.</summary>
        /// <param name="seed">any number.</param>
        /// <param name="index">any number.</param>
        /// <param name="strength">&gt;= 0; 1: the prior itself.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_model_sample()</remarks>
        public Mesh Sample(Session session, ulong seed, ulong index, double strength)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_model_sample(sessionAt, modelAt, seed, index, strength, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>The posterior model: what the template may still do once landmarks were seen. It is a model like any other, with
        /// a mean of its own, and may be conditioned again.</summary>
        /// <param name="observations">observation_count of them.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (name), MIEN_E_UNSUPPORTED_OPTION (mirror
        /// correlation), MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_model_condition()</remarks>
        public Model Condition(Session session, IReadOnlyList<LandmarkObservation> observations)
        {
            using (var call = new Call())
            {
                call.Required(observations, "observations");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var observationCount = call.Rows(observations, 1, "observations");
                var observationsAt = call.Records(observations, sizeof(Native.LandmarkObservation));
                var outAt = call.Room(8);
                call.Check(Functions.mien_model_condition(sessionAt, modelAt, observationsAt, (ulong)observationCount, outAt, call.Error));
                return call.Keep(new Model(call.Pointer(outAt)));
            }
        }

        /// <summary>Fits faces of known correspondence with a kernel of each length scale, and of each scale and number of levels
        /// that is asked for, and reports what is left.</summary>
        /// <param name="templateMesh">#V x 3, mm.</param>
        /// <param name="dataset">UTF-8 path of a dataset in the template's correspondence, its faces may cover only the template's first
        /// vertices.</param>
        /// <param name="options">sigmas_mm at least.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_NOT_FOUND (expression),
        /// MIEN_E_MISMATCH, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET,
        /// MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_model_tune()</remarks>
        public static Tuning Tune(Session session, Mesh templateMesh, string dataset, TuneOptions options, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var templateMeshAt = call.Use(templateMesh);
                var datasetAt = call.Text(dataset);
                var optionsAt = call.Required(options, "options").Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_model_tune(sessionAt, templateMeshAt, datasetAt, optionsAt, outAt, call.Error));
                return call.Keep(new Tuning(call.Pointer(outAt)));
            }
        }

        /// <summary>Fits faces of known correspondence with a kernel of each length scale, and of each scale and number of levels
        /// that is asked for, and reports what is left.</summary>
        /// <param name="templateMesh">#V x 3, mm.</param>
        /// <param name="dataset">UTF-8 path of a dataset in the template's correspondence, its faces may cover only the template's first
        /// vertices.</param>
        /// <param name="options">sigmas_mm at least.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_NOT_FOUND (expression),
        /// MIEN_E_MISMATCH, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET,
        /// MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_model_tune()</remarks>
        public static Task<Tuning> TuneAsync(Session session, Mesh templateMesh, string dataset, TuneOptions options, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Tune(session, templateMesh, dataset, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>The template.</summary>
        /// <exception cref="MienException">none; null for a null or wrong handle</exception>
        /// <remarks>C: mien_model_mesh()</remarks>
        public Mesh GetMesh()
        {
            using (var call = new Call())
            {
                var modelAt = call.Use(this);
                var lent = Functions.mien_model_mesh(modelAt);
                Functions.mien_mesh_retain(lent);
                return new Mesh(lent);
            }
        }

        /// <summary>The landmarks of a model: names and vertices of its template.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_model_get_landmarks()</remarks>
        public Landmarks GetLandmarks()
        {
            using (var call = new Call())
            {
                var modelAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_model_get_landmarks(modelAt, outAt, call.Error));
                return call.Keep(new Landmarks(call.Pointer(outAt)));
            }
        }

        /// <summary>The zones of a model: names and vertices of its template.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_model_get_zones()</remarks>
        public Zones GetZones()
        {
            using (var call = new Call())
            {
                var modelAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_model_get_zones(modelAt, outAt, call.Error));
                return call.Keep(new Zones(call.Pointer(outAt)));
            }
        }

        /// <summary>The coefficients that bring the template nearest to a face in its correspondence: least squares, weighted per
        /// vertex, with a ridge.</summary>
        /// <param name="target">mm, in the template's frame unless options.align; the vertices of the template, or its first ones.</param>
        /// <param name="options">may be left out: no weights, a ridge of 1 mm^2, all modes.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (vertices, weights), MIEN_E_INVALID_MESH,
        /// MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_model_fit()</remarks>
        public double[] Fit(Session session, Mesh target, ModelFitOptions options = null)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var targetAt = call.Use(target);
                var optionsAt = call.Record(options, sizeof(Native.ModelFitOptions), true, "options");
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_model_fit(sessionAt, modelAt, targetAt, optionsAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows);
            }
        }

        /// <summary>The face that has these coefficients: the template moved by the mean and the modes.</summary>
        /// <param name="coefficients">coefficient_count finite values</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (coefficient_count), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_model_synthesize()</remarks>
        public Mesh Synthesize(Session session, double[] coefficients = null)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var coefficientCount = call.Rows(coefficients, 1, "coefficients");
                var coefficientsAt = call.Array(coefficients);
                var outAt = call.Room(8);
                call.Check(Functions.mien_model_synthesize(sessionAt, modelAt, coefficientsAt, (ulong)coefficientCount, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }
    }

    /// <summary>A finished search for a kernel's settings. Immutable.</summary>
    public sealed unsafe class Tuning : NativeObject
    {
        internal Tuning(IntPtr owned) : base(owned, at => Functions.mien_tuning_release(at)) { }

        /// <summary>Residuals as JSON text by the two-call protocol: best_sigma_mm, best_scale_mm, best_levels and, per combination,
        /// its sigma, scale and levels, and mean, deviation and every face's residual norm in mm.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_tuning_get_json()</remarks>
        public string GetJson()
        {
            using (var call = new Call())
            {
                var tuningAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_tuning_get_json(tuningAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }
    }

    /// <summary>A list of named landmarks: places on a scan, or vertices of a template. Immutable: share freely.</summary>
    public sealed unsafe class Landmarks : NativeObject
    {
        internal Landmarks(IntPtr owned) : base(owned, at => Functions.mien_landmarks_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public Landmarks Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_landmarks_retain(at);
                return new Landmarks(at);
            }
        }

        /// <summary>Reads a landmark file, told by its content: this project's JSON ({"points": ...} or {"vertices": ...}), 3D
        /// Slicer's .mrk.json and .fcsv (coordinates come out as LPS), MeshLab's .pp, .pts, menpo's .ljson, tables
        /// name,x,y,z or name,vertex, and vertex numbers alone. What was not picked (null, not a number, "not defined", a
        /// repeated placeholder such as 0 0 0) is kept as such. Landmarks without a name are called by their number, from
        /// "1".</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_MEMORY_BUDGET,
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_landmarks_load()</remarks>
        public static Landmarks Load(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_landmarks_load(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new Landmarks(call.Pointer(outAt)));
            }
        }

        /// <summary>Makes a list of places from the host's. A repeated placeholder, such as 0 0 0, counts as not picked.</summary>
        /// <param name="landmarks">landmark_count of them; null allowed when that is 0. Names must differ.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_landmarks_create()</remarks>
        public static Landmarks Create(IReadOnlyList<ScanLandmark> landmarks = null)
        {
            using (var call = new Call())
            {
                var landmarkCount = call.Rows(landmarks, 1, "landmarks");
                var landmarksAt = call.Records(landmarks, sizeof(Native.ScanLandmark));
                var outAt = call.Room(8);
                call.Check(Functions.mien_landmarks_create(landmarksAt, (ulong)landmarkCount, outAt, call.Error));
                return call.Keep(new Landmarks(call.Pointer(outAt)));
            }
        }

        /// <summary>The landmarks under the names that a model has for them. Case, separators and leading zeros do not count;
        /// numbers alone are read as iBUG-68 (from 0 or 1) or MediaPipe (468 or 478), where the model has the 68 names of
        /// that scheme. What the model does not know is left out and listed in the JSON of the result.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (two names mean one landmark, numbers fit two schemes),
        /// MIEN_E_NOT_FOUND (none is known; the message gives examples of known names), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_landmarks_match()</remarks>
        public Landmarks Match(Model model)
        {
            using (var call = new Call())
            {
                var landmarksAt = call.Use(this);
                var modelAt = call.Use(model);
                var outAt = call.Room(8);
                call.Check(Functions.mien_landmarks_match(landmarksAt, modelAt, outAt, call.Error));
                return call.Keep(new Landmarks(call.Pointer(outAt)));
            }
        }

        /// <summary>The landmarks as places: vertex numbers become the vertices' places on a mesh, places stay as they are.</summary>
        /// <param name="mesh">has the numbered vertices.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (a number that the mesh does not have),
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_landmarks_on_mesh()</remarks>
        public Landmarks OnMesh(Mesh mesh)
        {
            using (var call = new Call())
            {
                var landmarksAt = call.Use(this);
                var meshAt = call.Use(mesh);
                var outAt = call.Room(8);
                call.Check(Functions.mien_landmarks_on_mesh(landmarksAt, meshAt, outAt, call.Error));
                return call.Keep(new Landmarks(call.Pointer(outAt)));
            }
        }

        /// <summary>Writes a landmark file by its extension: .json, .mrk.json and .fcsv (both LPS), .pp, .pts, .ljson, .csv. Vertex
        /// numbers go into .json and .csv. Atomic.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_MEMORY_BUDGET,
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_landmarks_save()</remarks>
        public void Save(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var landmarksAt = call.Use(this);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_landmarks_save(sessionAt, landmarksAt, pathAt, call.Error));
            }
        }

        /// <summary>How many landmarks there are, and how many of them are a place or a vertex.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_landmarks_get_counts()</remarks>
        public LandmarksCounts GetCounts()
        {
            using (var call = new Call())
            {
                var landmarksAt = call.Use(this);
                var countAt = call.Room(8);
                var pickedCountAt = call.Room(8);
                call.Check(Functions.mien_landmarks_get_counts(landmarksAt, countAt, pickedCountAt, call.Error));
                return new LandmarksCounts(*(ulong*)countAt, *(ulong*)pickedCountAt);
            }
        }

        /// <summary>The name of one landmark.</summary>
        /// <param name="index">below the count.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index)</exception>
        /// <remarks>C: mien_landmarks_get_name()</remarks>
        public string GetName(ulong index)
        {
            using (var call = new Call())
            {
                var landmarksAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_landmarks_get_name(landmarksAt, index, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>What is known of one landmark.</summary>
        /// <param name="index">below the count.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (misaligned), MIEN_E_NOT_FOUND (index)</exception>
        /// <remarks>C: mien_landmarks_get_mark()</remarks>
        public LandmarksMark GetMark(ulong index)
        {
            using (var call = new Call())
            {
                var landmarksAt = call.Use(this);
                var whereAt = call.Room(8);
                var positionAt = call.Room(8);
                var vertexAt = call.Room(8);
                call.Check(Functions.mien_landmarks_get_mark(landmarksAt, index, whereAt, positionAt, vertexAt, call.Error));
                return new LandmarksMark(*(int*)whereAt, *(double*)positionAt, *(uint*)vertexAt);
            }
        }

        /// <summary>What the list is, as JSON text by the two-call protocol: format, system (LPS or RAS as the file says it),
        /// unit_to_mm (null: not told), count, picked, not_picked (names), and after mien_landmarks_match() scheme and
        /// unknown (names).</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_landmarks_get_json()</remarks>
        public string GetJson()
        {
            using (var call = new Call())
            {
                var landmarksAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_landmarks_get_json(landmarksAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>The landmarks of a template and, beside them, those of its profile that its shape defines by itself: glabella,
        /// nasion, columella, sublabiale and pogonion, where they are not among the given ones. Every face in the
        /// template's topology has them at the same vertices.</summary>
        /// <param name="templateMesh">symmetric about its plane x = 0, +y up, +z forward (mien_model_mesh()).</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (a landmark that the search starts from),
        /// MIEN_E_MISMATCH (vertex), MIEN_E_INVALID_MESH (not symmetric, no midline), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_landmarks_add_profile()</remarks>
        public Landmarks AddProfile(Mesh templateMesh)
        {
            using (var call = new Call())
            {
                var landmarksAt = call.Use(this);
                var templateMeshAt = call.Use(templateMesh);
                var outAt = call.Room(8);
                call.Check(Functions.mien_landmarks_add_profile(landmarksAt, templateMeshAt, outAt, call.Error));
                return call.Keep(new Landmarks(call.Pointer(outAt)));
            }
        }
    }

    /// <summary>A list of named sets of vertices. Immutable: share freely.</summary>
    public sealed unsafe class Zones : NativeObject
    {
        internal Zones(IntPtr owned) : base(owned, at => Functions.mien_zones_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public Zones Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_zones_retain(at);
                return new Zones(at);
            }
        }

        /// <summary>Reads a zone file {"zones": {name: [vertex, ...]}}; further lists of vertices beside "zones", such as "lips",
        /// are zones too.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_MEMORY_BUDGET,
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_zones_load()</remarks>
        public static Zones Load(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_zones_load(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new Zones(call.Pointer(outAt)));
            }
        }

        /// <summary>Makes a list of zones from the host's.</summary>
        /// <param name="zones">zone_count of them, each of at most 16777216 vertices; null allowed when that is 0. Names must differ.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_zones_create()</remarks>
        public static Zones Create(IReadOnlyList<Zone> zones = null)
        {
            using (var call = new Call())
            {
                var zoneCount = call.Rows(zones, 1, "zones");
                var zonesAt = call.Records(zones, sizeof(Native.Zone));
                var outAt = call.Room(8);
                call.Check(Functions.mien_zones_create(zonesAt, (ulong)zoneCount, outAt, call.Error));
                return call.Keep(new Zones(call.Pointer(outAt)));
            }
        }

        /// <summary>Writes a zone file. Atomic.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_MEMORY_BUDGET,
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_zones_save()</remarks>
        public void Save(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var zonesAt = call.Use(this);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_zones_save(sessionAt, zonesAt, pathAt, call.Error));
            }
        }

        /// <summary>How many zones there are.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_zones_get_count()</remarks>
        public ulong GetCount()
        {
            using (var call = new Call())
            {
                var zonesAt = call.Use(this);
                var countAt = call.Room(8);
                call.Check(Functions.mien_zones_get_count(zonesAt, countAt, call.Error));
                return *(ulong*)countAt;
            }
        }

        /// <summary>The name of one zone.</summary>
        /// <param name="index">below the count.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index)</exception>
        /// <remarks>C: mien_zones_get_name()</remarks>
        public string GetName(ulong index)
        {
            using (var call = new Call())
            {
                var zonesAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_zones_get_name(zonesAt, index, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>The vertices of one zone. With dst null and capacity 0: their number only.</summary>
        /// <param name="index">below the count.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index)</exception>
        /// <remarks>C: mien_zones_get_vertices()</remarks>
        public uint[] GetVertices(ulong index)
        {
            using (var call = new Call())
            {
                var zonesAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(4);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 4);
                } while ((capacity = call.More(Functions.mien_zones_get_vertices(zonesAt, index, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadUints(dstAt, rows);
            }
        }
    }

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

    /// <summary>Mean and deviation of each measurement over the people of a dataset. Immutable: share freely.</summary>
    public sealed unsafe class Norms : NativeObject
    {
        internal Norms(IntPtr owned) : base(owned, at => Functions.mien_norms_release(at)) { }

        /// <summary>Norms over the neutral faces of a dataset, one vote per person. Norms are for the population of the dataset and
        /// for faces in its topology: the same landmark lies elsewhere on another template.</summary>
        /// <param name="datasetPath">faces of ten people or more.</param>
        /// <param name="landmarks">vertices of the dataset's faces.</param>
        /// <param name="options">may be left out; progress and cancel are read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (fewer than ten people, landmarks that are no vertices),
        /// MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_NOT_FOUND (no neutral faces, no measurement has its landmarks),
        /// MIEN_E_MISMATCH (landmarks), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_norms_create()</remarks>
        public static Norms Create(Session session, string datasetPath, Landmarks landmarks, AnthropometryOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var datasetPathAt = call.Text(datasetPath);
                var landmarksAt = call.Use(landmarks);
                var optionsAt = (options ?? new AnthropometryOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_norms_create(sessionAt, datasetPathAt, landmarksAt, optionsAt, outAt, call.Error));
                return call.Keep(new Norms(call.Pointer(outAt)));
            }
        }

        /// <summary>Norms over the neutral faces of a dataset, one vote per person. Norms are for the population of the dataset and
        /// for faces in its topology: the same landmark lies elsewhere on another template.</summary>
        /// <param name="datasetPath">faces of ten people or more.</param>
        /// <param name="landmarks">vertices of the dataset's faces.</param>
        /// <param name="options">may be left out; progress and cancel are read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (fewer than ten people, landmarks that are no vertices),
        /// MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_NOT_FOUND (no neutral faces, no measurement has its landmarks),
        /// MIEN_E_MISMATCH (landmarks), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_norms_create()</remarks>
        public static Task<Norms> CreateAsync(Session session, string datasetPath, Landmarks landmarks, AnthropometryOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Create(session, datasetPath, landmarks, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Reads norms that mien_norms_save() wrote, or that a host wrote from the literature: {"norms": {"n-gn": {"mean":
        /// 121.3, "sd": 6.8, "people": 109}}}.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (a norm of fewer than ten people, or given twice), MIEN_E_IO,
        /// MIEN_E_BAD_FORMAT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_norms_load()</remarks>
        public static Norms Load(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_norms_load(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new Norms(call.Pointer(outAt)));
            }
        }

        /// <summary>Writes norms as JSON. Atomic.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_norms_save()</remarks>
        public void Save(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var normsAt = call.Use(this);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_norms_save(sessionAt, normsAt, pathAt, call.Error));
            }
        }

        /// <summary>The norms as JSON text, as mien_norms_save() writes it.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_norms_get_json()</remarks>
        public string GetJson()
        {
            using (var call = new Call())
            {
                var normsAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_norms_get_json(normsAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }
    }

    /// <summary>What was measured: numbers per zone and values per vertex. Immutable: share freely.</summary>
    public sealed unsafe class Measurement : NativeObject
    {
        internal Measurement(IntPtr owned) : base(owned, at => Functions.mien_measurement_release(at)) { }

        /// <summary>How many zones were measured.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_measurement_get_zones()</remarks>
        public MeasurementZones GetZones()
        {
            using (var call = new Call())
            {
                var measurementAt = call.Use(this);
                var zoneCountAt = call.Room(8);
                var zonesDisjointAt = call.Room(8);
                call.Check(Functions.mien_measurement_get_zones(measurementAt, zoneCountAt, zonesDisjointAt, call.Error));
                return new MeasurementZones(*(uint*)zoneCountAt, *(int*)zonesDisjointAt);
            }
        }

        /// <summary>The volume of a zone.</summary>
        /// <param name="zone">0 .. zone_count - 1, MIEN_ZONE_WHOLE or MIEN_ZONE_REST.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (no such zone, no volume in it)</exception>
        /// <remarks>C: mien_measurement_get_volume()</remarks>
        public ZoneVolume GetVolume(int zone)
        {
            using (var call = new Call())
            {
                var measurementAt = call.Use(this);
                var outAt = call.Sized(sizeof(Native.ZoneVolume));
                call.Check(Functions.mien_measurement_get_volume(measurementAt, zone, outAt, call.Error));
                return ZoneVolume.Read(call, outAt);
            }
        }

        /// <summary>The distances of a zone.</summary>
        /// <param name="zone">0 .. zone_count - 1 or MIEN_ZONE_WHOLE.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (no such zone, no distance in it)</exception>
        /// <remarks>C: mien_measurement_get_distance()</remarks>
        public ZoneDistance GetDistance(int zone)
        {
            using (var call = new Call())
            {
                var measurementAt = call.Use(this);
                var outAt = call.Sized(sizeof(Native.ZoneDistance));
                call.Check(Functions.mien_measurement_get_distance(measurementAt, zone, outAt, call.Error));
                return ZoneDistance.Read(call, outAt);
            }
        }

        /// <summary>Copies a field with one float64 per vertex of the before face; NaN where there was no partner.</summary>
        /// <param name="field">MIEN_FIELD_*.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (this measurement has no such field)</exception>
        /// <remarks>C: mien_measurement_get_field()</remarks>
        public double[] GetField(Field field)
        {
            using (var call = new Call())
            {
                var measurementAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_measurement_get_field(measurementAt, (int)field, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows);
            }
        }

        /// <summary>The whole measurement as JSON text.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_measurement_get_json()</remarks>
        public string GetJson()
        {
            using (var call = new Call())
            {
                var measurementAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_measurement_get_json(measurementAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>The mirror plane of a comparison of left and right.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (another measurement)</exception>
        /// <remarks>C: mien_measurement_get_mirror_plane()</remarks>
        public MirrorPlane GetMirrorPlane()
        {
            using (var call = new Call())
            {
                var measurementAt = call.Use(this);
                var outAt = call.Sized(sizeof(Native.MirrorPlane));
                call.Check(Functions.mien_measurement_get_mirror_plane(measurementAt, outAt, call.Error));
                return MirrorPlane.Read(call, outAt);
            }
        }
    }

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

    /// <summary>Predicts one expression of a person from the neutral face. Immutable: share freely.</summary>
    public sealed unsafe class BlendshapeModel : NativeObject
    {
        internal BlendshapeModel(IntPtr owned) : base(owned, at => Functions.mien_blendshape_model_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public BlendshapeModel Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_blendshape_model_retain(at);
                return new BlendshapeModel(at);
            }
        }

        /// <summary>Learns to predict one expression from the neutral face, on every subject of a dataset that has both.</summary>
        /// <param name="datasetPath">a dataset file whose names include "neutral".</param>
        /// <param name="expression">a name of the dataset.</param>
        /// <param name="options">may be left out.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (fewer than 2 subjects, ridge), MIEN_E_NOT_FOUND (expression),
        /// MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY,
        /// MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_blendshape_model_train()</remarks>
        public static BlendshapeModel Train(Session session, string datasetPath, string expression, BlendshapeOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var datasetPathAt = call.Text(datasetPath);
                var expressionAt = call.Text(expression);
                var optionsAt = (options ?? new BlendshapeOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_blendshape_model_train(sessionAt, datasetPathAt, expressionAt, optionsAt, outAt, call.Error));
                return call.Keep(new BlendshapeModel(call.Pointer(outAt)));
            }
        }

        /// <summary>Learns to predict one expression from the neutral face, on every subject of a dataset that has both.</summary>
        /// <param name="datasetPath">a dataset file whose names include "neutral".</param>
        /// <param name="expression">a name of the dataset.</param>
        /// <param name="options">may be left out.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (fewer than 2 subjects, ridge), MIEN_E_NOT_FOUND (expression),
        /// MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY,
        /// MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_blendshape_model_train()</remarks>
        public static Task<BlendshapeModel> TrainAsync(Session session, string datasetPath, string expression, BlendshapeOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Train(session, datasetPath, expression, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Opens a blendshape model file.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_WRONG_KIND,
        /// MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_blendshape_model_load()</remarks>
        public static BlendshapeModel Load(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_blendshape_model_load(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new BlendshapeModel(call.Pointer(outAt)));
            }
        }

        /// <summary>Writes a blendshape model file (safetensors). Atomic.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_blendshape_model_save()</remarks>
        public void Save(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_blendshape_model_save(sessionAt, modelAt, pathAt, call.Error));
            }
        }

        /// <summary>The mean of the neutral training faces, centred: the mesh that a basis for this model is built on.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_blendshape_model_get_mean()</remarks>
        public Mesh GetMean()
        {
            using (var call = new Call())
            {
                var modelAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_blendshape_model_get_mean(modelAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>A person's expression from the neutral face, in its frame.</summary>
        /// <param name="k">low frequencies from the coordinates' prediction, high ones from the deformations'; 0 to the basis' modes, #V or
        /// more: coordinates alone.</param>
        /// <param name="neutral">#V vertices, mm.</param>
        /// <param name="basis">may be left out: then k = 0 gives the deformations' prediction, any other k the coordinates'.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (k), MIEN_E_MISMATCH (vertex counts), MIEN_E_NO_SOLUTION,
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_blendshape_model_predict()</remarks>
        public Mesh Predict(Session session, ulong k, Mesh neutral, SpectralBasis basis = null)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var basisAt = call.UseOrNull(basis);
                var neutralAt = call.Use(neutral);
                var outAt = call.Room(8);
                call.Check(Functions.mien_blendshape_model_predict(sessionAt, modelAt, basisAt, k, neutralAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Tries values of k on a dataset's subjects that the model was not trained on.</summary>
        /// <param name="datasetPath">subjects with a neutral face and the expression.</param>
        /// <param name="candidates">candidate_count values of k; above the basis' modes: coordinates alone.</param>
        /// <param name="options">may be left out; its ridge is not read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (expression), MIEN_E_MISMATCH, MIEN_E_IO,
        /// MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_blendshape_model_search()</remarks>
        public BandChoice[] Search(Session session, SpectralBasis basis, string datasetPath, string expression, ulong[] candidates, BlendshapeOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Required(candidates, "candidates");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var basisAt = call.Use(basis);
                var datasetPathAt = call.Text(datasetPath);
                var expressionAt = call.Text(expression);
                var candidateCount = call.Rows(candidates, 1, "candidates");
                var candidatesAt = call.Array(candidates);
                var optionsAt = (options ?? new BlendshapeOptions()).Write(call, progress, cancellationToken);
                var choicesAt = call.Room(candidateCount * sizeof(Native.BandChoice));
                call.Check(Functions.mien_blendshape_model_search(sessionAt, modelAt, basisAt, datasetPathAt, expressionAt, candidatesAt, (uint)candidateCount, optionsAt, choicesAt, call.Error));
                return call.ReadRecords(choicesAt, candidateCount, sizeof(Native.BandChoice), BandChoice.Read);
            }
        }

        /// <summary>Tries values of k on a dataset's subjects that the model was not trained on.</summary>
        /// <param name="datasetPath">subjects with a neutral face and the expression.</param>
        /// <param name="candidates">candidate_count values of k; above the basis' modes: coordinates alone.</param>
        /// <param name="options">may be left out; its ridge is not read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (expression), MIEN_E_MISMATCH, MIEN_E_IO,
        /// MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_blendshape_model_search()</remarks>
        public Task<BandChoice[]> SearchAsync(Session session, SpectralBasis basis, string datasetPath, string expression, ulong[] candidates, BlendshapeOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Search(session, basis, datasetPath, expression, candidates, options, progress, cancellationToken), cancellationToken);
        }
    }

    /// <summary>Collects faces with a subject and an expression each, then saves them as one safetensors file: vertices f32 [s,
    /// n, 3], subject i32 [s], expression i32 [s], triangles u32 [m, 3]. Externally synchronized.</summary>
    public sealed unsafe class DatasetWriter : NativeObject
    {
        internal DatasetWriter(IntPtr owned) : base(owned, at => Functions.mien_dataset_writer_release(at)) { }

        /// <summary>Starts a dataset in the topology of a mesh.</summary>
        /// <param name="topology">its triangles and vertex count hold for all faces.</param>
        /// <param name="expressionNames">expression_count UTF-8 names. One should be "neutral".</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_dataset_writer_create()</remarks>
        public static DatasetWriter Create(Session session, Mesh topology, IReadOnlyList<string> expressionNames)
        {
            using (var call = new Call())
            {
                call.Required(expressionNames, "expression_names");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var topologyAt = call.Use(topology);
                var expressionCount = call.Rows(expressionNames, 1, "expression_names");
                var expressionNamesAt = call.Texts(expressionNames);
                var outAt = call.Room(8);
                call.Check(Functions.mien_dataset_writer_create(sessionAt, topologyAt, expressionNamesAt, (uint)expressionCount, outAt, call.Error));
                return call.Keep(new DatasetWriter(call.Pointer(outAt)));
            }
        }

        /// <summary>Adds one face; its positions are copied.</summary>
        /// <param name="positions">#V x 3, F32 or F64, mm.</param>
        /// <param name="subject">any number that names the person.</param>
        /// <param name="expression">index into the expression names.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (vertex count), MIEN_E_INVALID_MESH (not
        /// finite), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_dataset_writer_add()</remarks>
        public void Add(Values positions, int subject, int expression)
        {
            using (var call = new Call())
            {
                call.Lock(this);
                var writerAt = call.Use(this);
                var positionsAt = call.View(positions, 3, "positions");
                call.Check(Functions.mien_dataset_writer_add(writerAt, positionsAt, subject, expression, call.Error));
            }
        }

        /// <summary>Writes all faces added so far. Atomic; more may be added and saved again.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no face), MIEN_E_IO, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_dataset_writer_save()</remarks>
        public void Save(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                call.Lock(this);
                var sessionAt = call.Use(session);
                var writerAt = call.Use(this);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_dataset_writer_save(sessionAt, writerAt, pathAt, call.Error));
            }
        }
    }

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
        /// MIEN_REGISTRATION_RADIUS95_MM, MIEN_REGISTRATION_NORMAL_DEVIATION_MM.</param>
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

        /// <summary>Keeps a registration as a file: the fitted template, its residuals, weights and deviations, the verdict and the
        /// model's zones, so that visits can be registered today and studied in a year. The scan is not in it.</summary>
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

    /// <summary>What was learned of faces and expressions: an identity subspace, an expression subspace, a prior of both.
    /// Immutable: share freely between threads.</summary>
    public sealed unsafe class ExpressionModel : NativeObject
    {
        internal ExpressionModel(IntPtr owned) : base(owned, at => Functions.mien_expression_model_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public ExpressionModel Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_expression_model_retain(at);
                return new ExpressionModel(at);
            }
        }

        /// <summary>Loads a model file. The file is treated as hostile; the modes stay in the mapped file.</summary>
        /// <exception cref="MienException">MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_CORRUPT, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_expression_model_load()</remarks>
        public static ExpressionModel Load(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_expression_model_load(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new ExpressionModel(call.Pointer(outAt)));
            }
        }

        /// <summary>Loads a model from the bytes of a model file that the host holds in memory. They are copied and checked like a
        /// file.</summary>
        /// <param name="data">size bytes, any alignment; not read after the call.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND,
        /// MIEN_E_UNSUPPORTED_VERSION, MIEN_E_CORRUPT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_expression_model_load_memory()</remarks>
        public static ExpressionModel LoadMemory(Session session, byte[] data)
        {
            using (var call = new Call())
            {
                call.Required(data, "data");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var size = call.Rows(data, 1, "data");
                var dataAt = call.Array(data);
                var outAt = call.Room(8);
                call.Check(Functions.mien_expression_model_load_memory(sessionAt, dataAt, (ulong)size, outAt, call.Error));
                return call.Keep(new ExpressionModel(call.Pointer(outAt)));
            }
        }

        /// <summary>Writes a model file (safetensors, kind "mien-expression-model"). Atomic.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_expression_model_save()</remarks>
        public void Save(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_expression_model_save(sessionAt, modelAt, pathAt, call.Error));
            }
        }

        /// <summary>Numbers of vertices and modes.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_expression_model_get_counts()</remarks>
        public ExpressionModelCounts GetCounts()
        {
            using (var call = new Call())
            {
                var modelAt = call.Use(this);
                var vertexCountAt = call.Room(8);
                var identityModesAt = call.Room(8);
                var expressionModesAt = call.Room(8);
                call.Check(Functions.mien_expression_model_get_counts(modelAt, vertexCountAt, identityModesAt, expressionModesAt, call.Error));
                return new ExpressionModelCounts(*(ulong*)vertexCountAt, *(uint*)identityModesAt, *(uint*)expressionModesAt);
            }
        }

        /// <summary>What the model is, and after training how the training went, as a JSON object: sizes, expressions, noise levels,
        /// iterations, orthogonality score per number of components, explained shares.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_expression_model_get_json()</remarks>
        public string GetJson()
        {
            using (var call = new Call())
            {
                var modelAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_expression_model_get_json(modelAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>A face made from coordinates: mean + identity modes x identity + expression modes x expression.</summary>
        /// <param name="identity">count identity_modes, F32 or F64, mm; count 0 (or null): the mean identity.</param>
        /// <param name="expression">count expression_modes, F32 or F64, mm; count 0 (or null): neutral.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (counts), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_expression_model_synthesize()</remarks>
        public Mesh Synthesize(Session session, Values identity = null, Values expression = null)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var identityAt = call.ViewOrNull(identity, 1, "identity");
                var expressionAt = call.ViewOrNull(expression, 1, "expression");
                var outAt = call.Room(8);
                call.Check(Functions.mien_expression_model_synthesize(sessionAt, modelAt, identityAt, expressionAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>A random face of the model: identity coordinates from their Gaussian, expression coordinates from the prior of
        /// one expression.</summary>
        /// <param name="seed">any number; the same seed gives the same face on every machine.</param>
        /// <param name="expression">name of an expression of the model, "neutral", "any" (all expressions together), or null: neutral without any
        /// expression.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (expression), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_expression_model_sample()</remarks>
        public Mesh Sample(Session session, ulong seed, string expression = null)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var expressionAt = call.TextOrNull(expression);
                var outAt = call.Room(8);
                call.Check(Functions.mien_expression_model_sample(sessionAt, modelAt, seed, expressionAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Puts the expression of one neutralized face onto another one's neutral face.</summary>
        /// <param name="source">whose expression is taken.</param>
        /// <param name="target">whose neutral face receives it.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_MISMATCH (another model), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_expression_model_transfer()</remarks>
        public Mesh Transfer(Session session, Neutralization source, Neutralization target)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var sourceAt = call.Use(source);
                var targetAt = call.Use(target);
                var outAt = call.Room(8);
                call.Check(Functions.mien_expression_model_transfer(sessionAt, modelAt, sourceAt, targetAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Trains an expression model from a dataset file (see dataset.h) with an expression named "neutral". The faces are
        /// read through a memory map in blocks, so the file may be larger than memory. Subjects without a neutral face are
        /// left out; missing expressions and repeated captures are fine.</summary>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_ARGUMENT (an option; no neutral faces; nothing to learn), MIEN_E_UNSUPPORTED_OPTION (a method
        /// that this library does not know), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_MEMORY_BUDGET,
        /// MIEN_E_NO_MEMORY, MIEN_E_NO_SOLUTION, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_expression_model_train()</remarks>
        public static ExpressionModel Train(Session session, string datasetPath, TrainOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var datasetPathAt = call.Text(datasetPath);
                var optionsAt = (options ?? new TrainOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_expression_model_train(sessionAt, datasetPathAt, optionsAt, outAt, call.Error));
                return call.Keep(new ExpressionModel(call.Pointer(outAt)));
            }
        }

        /// <summary>Trains an expression model from a dataset file (see dataset.h) with an expression named "neutral". The faces are
        /// read through a memory map in blocks, so the file may be larger than memory. Subjects without a neutral face are
        /// left out; missing expressions and repeated captures are fine.</summary>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_ARGUMENT (an option; no neutral faces; nothing to learn), MIEN_E_UNSUPPORTED_OPTION (a method
        /// that this library does not know), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_MEMORY_BUDGET,
        /// MIEN_E_NO_MEMORY, MIEN_E_NO_SOLUTION, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_expression_model_train()</remarks>
        public static Task<ExpressionModel> TrainAsync(Session session, string datasetPath, TrainOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Train(session, datasetPath, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Trains from shards. Equals training on all their faces at once to rounding, as long as no shard had to cut its
        /// rank.</summary>
        /// <param name="shardPaths">shard_count UTF-8 paths.</param>
        /// <param name="options">may be left out: defaults. stable_vertices must be empty: the shards' own count.</param>
        /// <exception cref="MienException">as mien_expression_model_train(); MIEN_E_WRONG_KIND, MIEN_E_MISMATCH (shards of different topologies, expression
        /// names or alignments), MIEN_E_INVALID_ARGUMENT (a subject in two shards)</exception>
        /// <remarks>C: mien_expression_model_merge()</remarks>
        public static ExpressionModel Merge(Session session, IReadOnlyList<string> shardPaths, TrainOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Required(shardPaths, "shard_paths");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var shardCount = call.Rows(shardPaths, 1, "shard_paths");
                var shardPathsAt = call.Texts(shardPaths);
                var optionsAt = (options ?? new TrainOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_expression_model_merge(sessionAt, shardPathsAt, (uint)shardCount, optionsAt, outAt, call.Error));
                return call.Keep(new ExpressionModel(call.Pointer(outAt)));
            }
        }

        /// <summary>Trains from shards. Equals training on all their faces at once to rounding, as long as no shard had to cut its
        /// rank.</summary>
        /// <param name="shardPaths">shard_count UTF-8 paths.</param>
        /// <param name="options">may be left out: defaults. stable_vertices must be empty: the shards' own count.</param>
        /// <exception cref="MienException">as mien_expression_model_train(); MIEN_E_WRONG_KIND, MIEN_E_MISMATCH (shards of different topologies, expression
        /// names or alignments), MIEN_E_INVALID_ARGUMENT (a subject in two shards)</exception>
        /// <remarks>C: mien_expression_model_merge()</remarks>
        public static Task<ExpressionModel> MergeAsync(Session session, IReadOnlyList<string> shardPaths, TrainOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Merge(session, shardPaths, options, progress, cancellationToken), cancellationToken);
        }
    }

    /// <summary>A neutralized face. Immutable: share freely between threads.</summary>
    public sealed unsafe class Neutralization : NativeObject
    {
        internal Neutralization(IntPtr owned) : base(owned, at => Functions.mien_neutralization_release(at)) { }

        /// <summary>The neutral face with the triangles, colours and texture of the input, borrowed.</summary>
        /// <exception cref="MienException">none (null for a null or released handle)</exception>
        /// <remarks>C: mien_neutralization_mesh()</remarks>
        public Mesh GetMesh()
        {
            using (var call = new Call())
            {
                var neutralizationAt = call.Use(this);
                var lent = Functions.mien_neutralization_mesh(neutralizationAt);
                Functions.mien_mesh_retain(lent);
                return new Mesh(lent);
            }
        }

        /// <summary>Numbers of vertices of the neutral face and of coordinates of mien_neutralization_get_coordinates().</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_neutralization_get_counts()</remarks>
        public NeutralizationCounts GetCounts()
        {
            using (var call = new Call())
            {
                var neutralizationAt = call.Use(this);
                var vertexCountAt = call.Room(8);
                var identityModesAt = call.Room(8);
                var expressionModesAt = call.Room(8);
                call.Check(Functions.mien_neutralization_get_counts(neutralizationAt, vertexCountAt, identityModesAt, expressionModesAt, call.Error));
                return new NeutralizationCounts(*(ulong*)vertexCountAt, *(uint*)identityModesAt, *(uint*)expressionModesAt);
            }
        }

        /// <summary>Coordinates of the face in the model, mm along the unit modes. mien_neutralization_get_counts() says how many.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_neutralization_get_coordinates()</remarks>
        public NeutralizationCoordinates GetCoordinates()
        {
            using (var call = new Call())
            {
                var neutralizationAt = call.Use(this);
                var identityAt = call.Room((long)this.GetCounts().IdentityModes * 8);
                var expressionAt = call.Room((long)this.GetCounts().ExpressionModes * 8);
                call.Check(Functions.mien_neutralization_get_coordinates(neutralizationAt, identityAt, expressionAt, call.Error));
                return new NeutralizationCoordinates(call.ReadDoubles(identityAt, (long)this.GetCounts().IdentityModes), call.ReadDoubles(expressionAt, (long)this.GetCounts().ExpressionModes));
            }
        }

        /// <summary>Deviation per vertex of the neutral face that comes from not knowing the expression, mm.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (options.uncertainty was 0, or a fit without a prior)</exception>
        /// <remarks>C: mien_neutralization_get_uncertainty()</remarks>
        public double[] GetUncertainty()
        {
            using (var call = new Call())
            {
                var neutralizationAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_neutralization_get_uncertainty(neutralizationAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows);
            }
        }

        /// <summary>How a treated zone is read, both ways: treatments of lips, brows and the corners of the mouth can look like
        /// expressions.</summary>
        /// <param name="reading">MIEN_READING_*.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (reading), MIEN_E_NOT_FOUND (nothing
        /// was treated)</exception>
        /// <remarks>C: mien_neutralization_get_reading()</remarks>
        public ZoneReading GetReading(Reading reading)
        {
            using (var call = new Call())
            {
                var neutralizationAt = call.Use(this);
                var outAt = call.Sized(sizeof(Native.ZoneReading));
                call.Check(Functions.mien_neutralization_get_reading(neutralizationAt, (int)reading, outAt, call.Error));
                return ZoneReading.Read(call, outAt);
            }
        }

        /// <summary>The report as a JSON object: expression found, its probability and the others', displacement, residual,
        /// coordinates; with options.treated both readings of the zone.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_neutralization_get_json()</remarks>
        public string GetJson()
        {
            using (var call = new Call())
            {
                var neutralizationAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_neutralization_get_json(neutralizationAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>Carries the neutralizing displacement onto the scan's own vertices; triangles, colours and texture of the scan
        /// stay. Parts far from the template move rigidly with their neighbourhood.</summary>
        /// <param name="scan">in the frame of the face.</param>
        /// <param name="maxDistanceMm">how far from the fitted face a vertex takes its displacement; 0: 6 mm.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_neutralization_apply_to_scan()</remarks>
        public Mesh ApplyToScan(Session session, Mesh scan, double maxDistanceMm)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var neutralizationAt = call.Use(this);
                var scanAt = call.Use(scan);
                var outAt = call.Room(8);
                call.Check(Functions.mien_neutralization_apply_to_scan(sessionAt, neutralizationAt, scanAt, maxDistanceMm, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }
    }

    /// <summary>Errors of neutralization over a dataset. Immutable: share freely between threads.</summary>
    public sealed unsafe class Evaluation : NativeObject
    {
        internal Evaluation(IntPtr owned) : base(owned, at => Functions.mien_evaluation_release(at)) { }

        /// <summary>The table as a JSON object: "expressions", a list, and "all" (without the neutral faces), each with faces,
        /// baseline, result, against (mean_mm, sd_mm, max_vertex_mm) and the effects cohens_d, superiority; with
        /// options.volume_zones "volumes", the same per zone (mean_ml, sd_ml, median_ml).</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_evaluation_get_json()</remarks>
        public string GetJson()
        {
            using (var call = new Call())
            {
                var evaluationAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_evaluation_get_json(evaluationAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }
    }

    /// <summary>Levels of a template with maps between them. Immutable: share freely.</summary>
    public sealed unsafe class Hierarchy : NativeObject
    {
        internal Hierarchy(IntPtr owned) : base(owned, at => Functions.mien_hierarchy_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public Hierarchy Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_hierarchy_retain(at);
                return new Hierarchy(at);
            }
        }

        /// <summary>Levels by quadric edge collapse, with barycentric maps up and selections down.</summary>
        /// <param name="mesh">an orientable manifold.</param>
        /// <param name="levelCount">levels below the mesh itself, 1 to 32; fewer when no collapse is legal.</param>
        /// <param name="factor">vertices are divided by this from level to level; above 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_hierarchy_build_quadric()</remarks>
        public static Hierarchy BuildQuadric(Session session, Mesh mesh, uint levelCount, double factor)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var meshAt = call.Use(mesh);
                var outAt = call.Room(8);
                call.Check(Functions.mien_hierarchy_build_quadric(sessionAt, meshAt, levelCount, factor, outAt, call.Error));
                return call.Keep(new Hierarchy(call.Pointer(outAt)));
            }
        }

        /// <summary>Levels sampled from the connectivity alone.</summary>
        /// <param name="levelCount">levels below the mesh itself, 1 to 32.</param>
        /// <param name="stride">least distance of kept vertices in edges, at least 1.</param>
        /// <param name="radius">edges over which the maps reach, stride - 1 to 64.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_hierarchy_build_connectivity()</remarks>
        public static Hierarchy BuildConnectivity(Session session, Mesh mesh, uint levelCount, uint stride, uint radius)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var meshAt = call.Use(mesh);
                var outAt = call.Room(8);
                call.Check(Functions.mien_hierarchy_build_connectivity(sessionAt, meshAt, levelCount, stride, radius, outAt, call.Error));
                return call.Keep(new Hierarchy(call.Pointer(outAt)));
            }
        }

        /// <summary>Opens a hierarchy file.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_WRONG_KIND,
        /// MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_hierarchy_load()</remarks>
        public static Hierarchy Load(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_hierarchy_load(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new Hierarchy(call.Pointer(outAt)));
            }
        }

        /// <summary>Writes a hierarchy file (safetensors; maps as compressed rows). Atomic.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_hierarchy_save()</remarks>
        public void Save(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var hierarchyAt = call.Use(this);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_hierarchy_save(sessionAt, hierarchyAt, pathAt, call.Error));
            }
        }

        /// <summary>Number of levels, the finest included.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT</exception>
        /// <remarks>C: mien_hierarchy_get_level_count()</remarks>
        public uint GetLevelCount()
        {
            using (var call = new Call())
            {
                var hierarchyAt = call.Use(this);
                var levelCountAt = call.Room(8);
                call.Check(Functions.mien_hierarchy_get_level_count(hierarchyAt, levelCountAt, call.Error));
                return *(uint*)levelCountAt;
            }
        }

        /// <summary>The mesh of a level; level 0 is the finest. Sampled levels of the connectivity kind have no triangles.</summary>
        /// <param name="level">0 to level_count - 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (level), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_hierarchy_get_level()</remarks>
        public Mesh GetLevel(uint level)
        {
            using (var call = new Call())
            {
                var hierarchyAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_hierarchy_get_level(hierarchyAt, level, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Applies a map to values on vertices: dst = map values.</summary>
        /// <param name="level">1 to level_count - 1: the coarser level of the map.</param>
        /// <param name="direction">MIEN_MAP_DOWN or MIEN_MAP_UP.</param>
        /// <param name="values">row_count x channel_count row-major float64.</param>
        /// <param name="channelCount">values a vertex, 1 to 4096.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (direction), MIEN_E_MISMATCH
        /// (row_count), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_hierarchy_apply()</remarks>
        public double[] Apply(uint level, MapKind direction, double[] values, ulong channelCount)
        {
            using (var call = new Call())
            {
                call.Required(values, "values");
                var hierarchyAt = call.Use(this);
                var rowCount = call.Rows(values, (long) channelCount, "values");
                var valuesAt = call.Array(values);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity((long) channelCount * 8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * (long) channelCount * 8);
                } while ((capacity = call.More(Functions.mien_hierarchy_apply(hierarchyAt, level, (int)direction, valuesAt, (ulong)rowCount, channelCount, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows * (long) channelCount);
            }
        }

        /// <summary>A map as a sparse matrix: its entries by rows, ascending, each row adding up to one. With all arrays null and
        /// capacity 0: the counts only.</summary>
        /// <param name="level">1 to level_count - 1: the coarser level of the map.</param>
        /// <param name="direction">MIEN_MAP_DOWN or MIEN_MAP_UP.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (direction)</exception>
        /// <remarks>C: mien_hierarchy_get_map()</remarks>
        public HierarchyMap GetMap(uint level, MapKind direction)
        {
            using (var call = new Call())
            {
                var hierarchyAt = call.Use(this);
                var rowCountAt = call.Room(8);
                var columnCountAt = call.Room(8);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr rowsAt;
                IntPtr columnsAt;
                IntPtr valuesAt;
                do {
                    rowsAt = call.Room(capacity * 4);
                    columnsAt = call.Room(capacity * 4);
                    valuesAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_hierarchy_get_map(hierarchyAt, level, (int)direction, rowsAt, columnsAt, valuesAt, (ulong)capacity, countAt, rowCountAt, columnCountAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return new HierarchyMap(call.ReadUints(rowsAt, rows), call.ReadUints(columnsAt, rows), call.ReadDoubles(valuesAt, rows), *(ulong*)rowCountAt, *(ulong*)columnCountAt);
            }
        }
    }

    /// <summary>A trained network with everything that belongs to it: layers, weights, neighbour lists and statistics of one
    /// template. Immutable: share freely.</summary>
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
        /// decoder), MIEN_E_MISMATCH (code_count), MIEN_E_NO_SOLUTION (a result that is not finite), MIEN_E_NO_MEMORY,
        /// MIEN_E_CANCELLED</exception>
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
        /// network was trained to make of a face (a neutral one into an expression). Networks on deformations, which know
        /// no place, have their result put onto the face rigidly.</summary>
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

        /// <summary>How well the network gives back the faces of a dataset, as JSON: l1_mm, l2_mm, dame and fmpd as means over the
        /// faces and by face. Judge a network on people that it was not trained on.</summary>
        /// <param name="datasetPath">a dataset file in the network's topology.</param>
        /// <param name="options">may be left out: all faces.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a half is missing, a switch),
        /// MIEN_E_MISMATCH (vertex count), MIEN_E_NOT_FOUND (no such face), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
        /// MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
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
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a half is missing, a switch),
        /// MIEN_E_MISMATCH (vertex count), MIEN_E_NOT_FOUND (no such face), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
        /// MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_network_evaluate()</remarks>
        public Task<string> EvaluateAsync(Session session, string datasetPath, NetworkEvaluationOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Evaluate(session, datasetPath, options, progress, cancellationToken), cancellationToken);
        }
    }

    /// <summary>A trained representation of faces: numbers for learning, with their exact inverse. Immutable: share freely.</summary>
    public sealed unsafe class Representation : NativeObject
    {
        internal Representation(IntPtr owned) : base(owned, at => Functions.mien_representation_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public Representation Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_representation_retain(at);
                return new Representation(at);
            }
        }

        /// <summary>mien_representation_train_with_options() without progress and cancel.</summary>
        /// <param name="datasetPath">a dataset file.</param>
        /// <param name="kind">MIEN_FEATURES_...</param>
        /// <param name="neutralOnly">1: only the faces marked neutral; 0: all.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (kind, neutral_only), MIEN_E_IO,
        /// MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NOT_FOUND (no neutral face), MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET,
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_representation_train()</remarks>
        public static Representation Train(Session session, string datasetPath, Features kind, int neutralOnly)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var datasetPathAt = call.Text(datasetPath);
                var outAt = call.Room(8);
                call.Check(Functions.mien_representation_train(sessionAt, datasetPathAt, (int)kind, neutralOnly, outAt, call.Error));
                return call.Keep(new Representation(call.Pointer(outAt)));
            }
        }

        /// <summary>Learns the mean shape, scale and statistics of a dataset's faces, with progress and cancel.</summary>
        /// <param name="datasetPath">a dataset file.</param>
        /// <param name="kind">MIEN_FEATURES_...</param>
        /// <param name="options">may be left out: all faces.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (kind, neutral_only), MIEN_E_IO,
        /// MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NOT_FOUND (no neutral face), MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET,
        /// MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_representation_train_with_options()</remarks>
        public static Representation TrainWithOptions(Session session, string datasetPath, Features kind, RepresentationOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var datasetPathAt = call.Text(datasetPath);
                var optionsAt = (options ?? new RepresentationOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_representation_train_with_options(sessionAt, datasetPathAt, (int)kind, optionsAt, outAt, call.Error));
                return call.Keep(new Representation(call.Pointer(outAt)));
            }
        }

        /// <summary>Learns the mean shape, scale and statistics of a dataset's faces, with progress and cancel.</summary>
        /// <param name="datasetPath">a dataset file.</param>
        /// <param name="kind">MIEN_FEATURES_...</param>
        /// <param name="options">may be left out: all faces.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (kind, neutral_only), MIEN_E_IO,
        /// MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NOT_FOUND (no neutral face), MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET,
        /// MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_representation_train_with_options()</remarks>
        public static Task<Representation> TrainWithOptionsAsync(Session session, string datasetPath, Features kind, RepresentationOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => TrainWithOptions(session, datasetPath, kind, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Opens a representation file.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_WRONG_KIND,
        /// MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_representation_load()</remarks>
        public static Representation Load(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_representation_load(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new Representation(call.Pointer(outAt)));
            }
        }

        /// <summary>Writes a representation file (safetensors). Atomic.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_representation_save()</remarks>
        public void Save(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var representationAt = call.Use(this);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_representation_save(sessionAt, representationAt, pathAt, call.Error));
            }
        }

        /// <summary>Numbers of vertices and of features a vertex.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_representation_get_counts()</remarks>
        public RepresentationCounts GetCounts()
        {
            using (var call = new Call())
            {
                var representationAt = call.Use(this);
                var vertexCountAt = call.Room(8);
                var channelCountAt = call.Room(8);
                call.Check(Functions.mien_representation_get_counts(representationAt, vertexCountAt, channelCountAt, call.Error));
                return new RepresentationCounts(*(ulong*)vertexCountAt, *(ulong*)channelCountAt);
            }
        }

        /// <summary>The features of a face, #V x c row-major float64. With dst null and capacity 0: writes the count only.</summary>
        /// <param name="face">#V vertices, mm, anywhere.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (vertex count), MIEN_E_NO_SOLUTION,
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_representation_encode()</remarks>
        public RepresentationEncode Encode(Session session, Mesh face)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var representationAt = call.Use(this);
                var faceAt = call.Use(face);
                var motionAt = call.Room(12 * 8);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity((long)this.GetCounts().ChannelCount * 8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * (long)this.GetCounts().ChannelCount * 8);
                } while ((capacity = call.More(Functions.mien_representation_encode(sessionAt, representationAt, faceAt, motionAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return new RepresentationEncode(call.ReadDoubles(motionAt, 12), call.ReadDoubles(dstAt, rows * (long)this.GetCounts().ChannelCount));
            }
        }

        /// <summary>The face that has these features.</summary>
        /// <param name="features">row_count x channel_count row-major float64.</param>
        /// <param name="motion">may be left out: the mean's frame; 12 float64 of mien_representation_encode(), which is undone.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (not finite, motion not rigid), MIEN_E_MISMATCH (row_count),
        /// MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_representation_decode()</remarks>
        public Mesh Decode(Session session, double[] features, double[] motion = null)
        {
            using (var call = new Call())
            {
                call.Required(features, "features");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var representationAt = call.Use(this);
                var rowCount = call.Rows(features, (long)this.GetCounts().ChannelCount, "features");
                var featuresAt = call.Array(features);
                call.Agree("motion", call.Rows(motion, 1, "motion"), 12);
                var motionAt = call.Array(motion);
                var outAt = call.Room(8);
                call.Check(Functions.mien_representation_decode(sessionAt, representationAt, featuresAt, (ulong)rowCount, motionAt, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }
    }

    /// <summary>A trained score: partial least squares on displacement and curvature. Immutable: share freely.</summary>
    public sealed unsafe class ScoreModel : NativeObject
    {
        internal ScoreModel(IntPtr owned) : base(owned, at => Functions.mien_score_model_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public ScoreModel Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_score_model_retain(at);
                return new ScoreModel(at);
            }
        }

        /// <summary>Learns a score from graded faces in correspondence.</summary>
        /// <param name="datasetPath">a dataset file, faces of one subject share a fold.</param>
        /// <param name="grades">grade_count values, one per face, NaN: not graded.</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (settings, fewer than 6 graded faces), MIEN_E_MISMATCH (counts,
        /// zones), MIEN_E_NO_SOLUTION (grades do not vary), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
        /// MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_score_model_train()</remarks>
        public static ScoreModel Train(Session session, string datasetPath, double[] grades, ScoreOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Required(grades, "grades");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var datasetPathAt = call.Text(datasetPath);
                var gradeCount = call.Rows(grades, 1, "grades");
                var gradesAt = call.Array(grades);
                var optionsAt = (options ?? new ScoreOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_score_model_train(sessionAt, datasetPathAt, gradesAt, (ulong)gradeCount, optionsAt, outAt, call.Error));
                return call.Keep(new ScoreModel(call.Pointer(outAt)));
            }
        }

        /// <summary>Learns a score from graded faces in correspondence.</summary>
        /// <param name="datasetPath">a dataset file, faces of one subject share a fold.</param>
        /// <param name="grades">grade_count values, one per face, NaN: not graded.</param>
        /// <param name="options">may be left out: defaults.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (settings, fewer than 6 graded faces), MIEN_E_MISMATCH (counts,
        /// zones), MIEN_E_NO_SOLUTION (grades do not vary), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
        /// MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_score_model_train()</remarks>
        public static Task<ScoreModel> TrainAsync(Session session, string datasetPath, double[] grades, ScoreOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Train(session, datasetPath, grades, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>Reads a score model file, which is treated as hostile.</summary>
        /// <exception cref="MienException">MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_CORRUPT, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_score_model_load()</remarks>
        public static ScoreModel Load(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var pathAt = call.Text(path);
                var outAt = call.Room(8);
                call.Check(Functions.mien_score_model_load(sessionAt, pathAt, outAt, call.Error));
                return call.Keep(new ScoreModel(call.Pointer(outAt)));
            }
        }

        /// <summary>Writes a score model as a safetensors file, atomically.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_score_model_save()</remarks>
        public void Save(Session session, string path)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var pathAt = call.Text(path);
                call.Check(Functions.mien_score_model_save(sessionAt, modelAt, pathAt, call.Error));
            }
        }

        /// <summary>The score of a face with its 95 % prediction interval.</summary>
        /// <param name="face">in the model's topology, mm, anywhere in space.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (topology), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_score_model_predict()</remarks>
        public ScorePrediction Predict(Session session, Mesh face)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var faceAt = call.Use(face);
                var outAt = call.Sized(sizeof(Native.ScorePrediction));
                call.Check(Functions.mien_score_model_predict(sessionAt, modelAt, faceAt, outAt, call.Error));
                return ScorePrediction.Read(call, outAt);
            }
        }

        /// <summary>The face as it would look with another score.</summary>
        /// <param name="target">the score wanted, finite.</param>
        /// <param name="face">may be left out: the training's mean face.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (topology), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_score_model_simulate()</remarks>
        public Mesh Simulate(Session session, double target, Mesh face = null)
        {
            using (var call = new Call())
            {
                call.Lock(session);
                var sessionAt = call.Use(session);
                var modelAt = call.Use(this);
                var faceAt = call.UseOrNull(face);
                var outAt = call.Room(8);
                call.Check(Functions.mien_score_model_simulate(sessionAt, modelAt, faceAt, target, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>A latent variable on the template: how far each vertex moves, mm, at one standard deviation of it. Component -1:
        /// per unit of score.</summary>
        /// <param name="component">0 .. components - 1, or -1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (no such component)</exception>
        /// <remarks>C: mien_score_model_get_latent()</remarks>
        public double[] GetLatent(int component)
        {
            using (var call = new Call())
            {
                var modelAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_score_model_get_latent(modelAt, component, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows);
            }
        }

        /// <summary>What was learned as JSON: components, cross-validated errors, held-out predictions and focus_places (how many
        /// places the focus takes a face for; 0: none), which are not kept in files.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_score_model_get_json()</remarks>
        public string GetJson()
        {
            using (var call = new Call())
            {
                var modelAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_score_model_get_json(modelAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }
    }

    /// <summary>Several scans of one person, neutralized together. Immutable: share freely between threads.</summary>
    public sealed unsafe class Series : NativeObject
    {
        internal Series(IntPtr owned) : base(owned, at => Functions.mien_series_release(at)) { }

        /// <summary>The neutral mesh of one face of a series, in that face's frame; or the person's shared one.</summary>
        /// <param name="index">0 to face_count - 1, or -1: the shared neutral face, in the training's frame.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (index), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_series_get_mesh()</remarks>
        public Mesh GetMesh(int index)
        {
            using (var call = new Call())
            {
                var seriesAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_series_get_mesh(seriesAt, index, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>The report as a JSON object: "faces", a list with each face's expression, residual_rms_mm (distance from its own
        /// fit), distance_to_shared_mm (root mean square distance of its neutral face from the shared one, without the
        /// changing vertices) and warnings.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_series_get_json()</remarks>
        public string GetJson()
        {
            using (var call = new Call())
            {
                var seriesAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_series_get_json(seriesAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }
    }

    /// <summary>Visits of one person: neutral faces and what changed between them. Immutable: share freely.</summary>
    public sealed unsafe class Study : NativeObject
    {
        internal Study(IntPtr owned) : base(owned, at => Functions.mien_study_release(at)) { }

        /// <summary>One more object for the same native one: each may be disposed by itself.</summary>
        public Study Share()
        {
            using (var call = new Call())
            {
                var at = call.Use(this);
                Functions.mien_study_retain(at);
                return new Study(at);
            }
        }

        /// <summary>Studies the visits of one person: takes the expressions off all faces together, aligns each visit on the first
        /// by what holds still, and measures what changed per zone with its errors. One registration: its neutral face and
        /// how surely it is known.</summary>
        /// <param name="registrations">registration_count fits of one model, first visit first.</param>
        /// <param name="expressions">may be left out: faces are measured as they are held.</param>
        /// <param name="options">may be left out: defaults, with the zones of the registrations' model.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (topology, zones),
        /// MIEN_E_NOT_FOUND (a zone's name), MIEN_E_NO_SOLUTION, MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_MEMORY,
        /// MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_study_create()</remarks>
        public static Study Create(Session session, IReadOnlyList<Registration> registrations, ExpressionModel expressions = null, StudyOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Required(registrations, "registrations");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var registrationCount = call.Rows(registrations, 1, "registrations");
                var registrationsAt = call.Handles(registrations);
                var expressionsAt = call.UseOrNull(expressions);
                var optionsAt = (options ?? new StudyOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_study_create(sessionAt, registrationsAt, (uint)registrationCount, expressionsAt, optionsAt, outAt, call.Error));
                return call.Keep(new Study(call.Pointer(outAt)));
            }
        }

        /// <summary>Studies the visits of one person: takes the expressions off all faces together, aligns each visit on the first
        /// by what holds still, and measures what changed per zone with its errors. One registration: its neutral face and
        /// how surely it is known.</summary>
        /// <param name="registrations">registration_count fits of one model, first visit first.</param>
        /// <param name="expressions">may be left out: faces are measured as they are held.</param>
        /// <param name="options">may be left out: defaults, with the zones of the registrations' model.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (topology, zones),
        /// MIEN_E_NOT_FOUND (a zone's name), MIEN_E_NO_SOLUTION, MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_MEMORY,
        /// MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_study_create()</remarks>
        public static Task<Study> CreateAsync(Session session, IReadOnlyList<Registration> registrations, ExpressionModel expressions = null, StudyOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => Create(session, registrations, expressions, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>The same from meshes that were fitted elsewhere. Without deviations nothing is said of errors: sd, low, high and
        /// limit_of_detection are NaN.</summary>
        /// <param name="faces">face_count meshes in one topology, mm, first visit first.</param>
        /// <param name="normalSd">may be left out; face_count x #V values, face by face, mm, &gt;= 0: how far each surface may lie off the skin
        /// along its normal.</param>
        /// <param name="weights">may be left out: all was seen, as far as is known; face_count x #V values, face by face, 0 to 1: 0 where a scan
        /// had no data.</param>
        /// <param name="expressions">may be left out: faces are measured as they are held.</param>
        /// <param name="options">may be left out: defaults, without any zone. noise_mm is not read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (topology, zones,
        /// deviations, weights), MIEN_E_NOT_FOUND (a zone's name), MIEN_E_NO_SOLUTION, MIEN_E_UNSUPPORTED_OPTION,
        /// MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_study_create_from_meshes()</remarks>
        public static Study CreateFromMeshes(Session session, IReadOnlyList<Mesh> faces, Values normalSd = null, Values weights = null, ExpressionModel expressions = null, StudyOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new Call())
            {
                call.Required(faces, "faces");
                call.Lock(session);
                var sessionAt = call.Use(session);
                var faceCount = call.Rows(faces, 1, "faces");
                var facesAt = call.Handles(faces);
                var normalSdAt = call.ViewOrNull(normalSd, 1, "normal_sd");
                var weightsAt = call.ViewOrNull(weights, 1, "weights");
                var expressionsAt = call.UseOrNull(expressions);
                var optionsAt = (options ?? new StudyOptions()).Write(call, progress, cancellationToken);
                var outAt = call.Room(8);
                call.Check(Functions.mien_study_create_from_meshes(sessionAt, facesAt, (uint)faceCount, normalSdAt, weightsAt, expressionsAt, optionsAt, outAt, call.Error));
                return call.Keep(new Study(call.Pointer(outAt)));
            }
        }

        /// <summary>The same from meshes that were fitted elsewhere. Without deviations nothing is said of errors: sd, low, high and
        /// limit_of_detection are NaN.</summary>
        /// <param name="faces">face_count meshes in one topology, mm, first visit first.</param>
        /// <param name="normalSd">may be left out; face_count x #V values, face by face, mm, &gt;= 0: how far each surface may lie off the skin
        /// along its normal.</param>
        /// <param name="weights">may be left out: all was seen, as far as is known; face_count x #V values, face by face, 0 to 1: 0 where a scan
        /// had no data.</param>
        /// <param name="expressions">may be left out: faces are measured as they are held.</param>
        /// <param name="options">may be left out: defaults, without any zone. noise_mm is not read.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (topology, zones,
        /// deviations, weights), MIEN_E_NOT_FOUND (a zone's name), MIEN_E_NO_SOLUTION, MIEN_E_UNSUPPORTED_OPTION,
        /// MIEN_E_NO_MEMORY, MIEN_E_CANCELLED</exception>
        /// <remarks>C: mien_study_create_from_meshes()</remarks>
        public static Task<Study> CreateFromMeshesAsync(Session session, IReadOnlyList<Mesh> faces, Values normalSd = null, Values weights = null, ExpressionModel expressions = null, StudyOptions options = null, IProgress<Progress> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Task.Run(() => CreateFromMeshes(session, faces, normalSd, weights, expressions, options, progress, cancellationToken), cancellationToken);
        }

        /// <summary>How many visits and zones a study has. The treated zones with their margin are the last zones.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE</exception>
        /// <remarks>C: mien_study_get_counts()</remarks>
        public StudyCounts GetCounts()
        {
            using (var call = new Call())
            {
                var studyAt = call.Use(this);
                var visitCountAt = call.Room(8);
                var zoneCountAt = call.Room(8);
                call.Check(Functions.mien_study_get_counts(studyAt, visitCountAt, zoneCountAt, call.Error));
                return new StudyCounts(*(uint*)visitCountAt, *(uint*)zoneCountAt);
            }
        }

        /// <summary>The name of a zone.</summary>
        /// <param name="zone">0 to zone_count - 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (zone)</exception>
        /// <remarks>C: mien_study_get_zone_name()</remarks>
        public string GetZoneName(int zone)
        {
            using (var call = new Call())
            {
                var studyAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_study_get_zone_name(studyAt, zone, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>The name of the expression that was taken off a visit.</summary>
        /// <param name="visit">0 to visit_count - 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (visit)</exception>
        /// <remarks>C: mien_study_get_expression()</remarks>
        public string GetExpression(int visit)
        {
            using (var call = new Call())
            {
                var studyAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_study_get_expression(studyAt, visit, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>The neutral face of a visit, in its own frame or aligned on another visit.</summary>
        /// <param name="visit">0 to visit_count - 1.</param>
        /// <param name="frame">the visit in whose frame to give it: its own number for its own frame.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (a visit), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_study_get_mesh()</remarks>
        public Mesh GetMesh(int visit, int frame)
        {
            using (var call = new Call())
            {
                var studyAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_study_get_mesh(studyAt, visit, frame, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>Copies a field with one float64 per vertex of a visit's face.</summary>
        /// <param name="visit">0 to visit_count - 1.</param>
        /// <param name="field">MIEN_STUDY_FIELD_*.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (visit, or nothing is known of such a field)</exception>
        /// <remarks>C: mien_study_get_field()</remarks>
        public double[] GetField(int visit, StudyField field)
        {
            using (var call = new Call())
            {
                var studyAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_study_get_field(studyAt, visit, (int)field, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows);
            }
        }

        /// <summary>How far each vertex moved between two visits: the signed distance of the second neutral face, aligned, from the
        /// first along the first one's normals, mm.</summary>
        /// <param name="first">0 to visit_count - 1.</param>
        /// <param name="second">another visit.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (first is second), MIEN_E_NOT_FOUND (a visit),
        /// MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_study_get_distances()</remarks>
        public double[] GetDistances(int first, int second)
        {
            using (var call = new Call())
            {
                var studyAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(8);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity * 8);
                } while ((capacity = call.More(Functions.mien_study_get_distances(studyAt, first, second, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                var rows = call.Count(countAt);
                return call.ReadDoubles(dstAt, rows);
            }
        }

        /// <summary>How the second visit was aligned on the first.</summary>
        /// <param name="first">0 to visit_count - 1.</param>
        /// <param name="second">another visit.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (first is second), MIEN_E_NOT_FOUND (a visit),
        /// MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_study_get_alignment()</remarks>
        public ZoneAlignment GetAlignment(int first, int second)
        {
            using (var call = new Call())
            {
                var studyAt = call.Use(this);
                var outAt = call.Sized(sizeof(Native.ZoneAlignment));
                call.Check(Functions.mien_study_get_alignment(studyAt, first, second, outAt, call.Error));
                return ZoneAlignment.Read(call, outAt);
            }
        }

        /// <summary>What changed in a zone from one visit to another.</summary>
        /// <param name="first">0 to visit_count - 1.</param>
        /// <param name="second">another visit.</param>
        /// <param name="zone">0 to zone_count - 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (first is second), MIEN_E_NOT_FOUND (a visit or zone),
        /// MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_study_get_change()</remarks>
        public StudyChange GetChange(int first, int second, int zone)
        {
            using (var call = new Call())
            {
                var studyAt = call.Use(this);
                var outAt = call.Sized(sizeof(Native.StudyChange));
                call.Check(Functions.mien_study_get_change(studyAt, first, second, zone, outAt, call.Error));
                return StudyChange.Read(call, outAt);
            }
        }

        /// <summary>The study as a JSON object: "recipe" with every setting, "zones", and "visits" with the expression of each and
        /// "changes_since_first" per zone.</summary>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_study_get_json()</remarks>
        public string GetJson()
        {
            using (var call = new Call())
            {
                var studyAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_study_get_json(studyAt, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }
    }

    /// <summary>One person's faces at several visits, without their expressions. Immutable: share freely between threads.</summary>
    public sealed unsafe class Visits : NativeObject
    {
        internal Visits(IntPtr owned) : base(owned, at => Functions.mien_visits_release(at)) { }

        /// <summary>The neutral face of one visit, in the frame of its face.</summary>
        /// <param name="index">0 to face_count - 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (index), MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_visits_get_mesh()</remarks>
        public Mesh GetMesh(int index)
        {
            using (var call = new Call())
            {
                var visitsAt = call.Use(this);
                var outAt = call.Room(8);
                call.Check(Functions.mien_visits_get_mesh(visitsAt, index, outAt, call.Error));
                return call.Keep(new Mesh(call.Pointer(outAt)));
            }
        }

        /// <summary>The name of the expression found at one visit.</summary>
        /// <param name="index">0 to face_count - 1.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (index)</exception>
        /// <remarks>C: mien_visits_get_expression()</remarks>
        public string GetExpression(int index)
        {
            using (var call = new Call())
            {
                var visitsAt = call.Use(this);
                var countAt = call.Room(8);
                long capacity = call.FirstCapacity(1);
                IntPtr dstAt;
                do {
                    dstAt = call.Room(capacity);
                } while ((capacity = call.More(Functions.mien_visits_get_expression(visitsAt, index, dstAt, (ulong)capacity, countAt, call.Error), capacity, countAt)) != 0);
                return call.ReadText(dstAt, call.Count(countAt));
            }
        }

        /// <summary>What the expressions that were taken off amount to in a volume between two visits, and how surely they are
        /// known. A neutral volume carries that doubt beside the doubts of the fits.</summary>
        /// <param name="first">0 to face_count - 1.</param>
        /// <param name="second">0 to face_count - 1.</param>
        /// <param name="zone">may be left out: the whole face.</param>
        /// <exception cref="MienException">MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (zone), MIEN_E_NOT_FOUND (a visit),
        /// MIEN_E_NO_MEMORY</exception>
        /// <remarks>C: mien_visits_get_removed_volume()</remarks>
        public VisitsRemovedVolume GetRemovedVolume(int first, int second, Zone zone = null)
        {
            using (var call = new Call())
            {
                var visitsAt = call.Use(this);
                var zoneAt = call.Record(zone, sizeof(Native.Zone), true, "zone");
                var removedMlAt = call.Room(8);
                var sdMlAt = call.Room(8);
                call.Check(Functions.mien_visits_get_removed_volume(visitsAt, first, second, zoneAt, removedMlAt, sdMlAt, call.Error));
                return new VisitsRemovedVolume(*(double*)removedMlAt, *(double*)sdMlAt);
            }
        }
    }

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
