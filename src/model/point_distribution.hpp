// A point distribution model: mean and principal modes of the displacements of registered faces
// (2.1)-(2.2). It sharpens a deformation model: u = mean + pca_modes c + basis a with c and a
// standard normal, so the modes carry what the training faces do and the kernel, whose scale then
// stands for what they leave over, carries the rest.
//
// Faces may cover only the first vertices of the template. Their displacement is carried on by the
// surface that bends and stretches least: (L M^-1 L + L / length^2) u = 0 outside.
#pragma once

#include "base/context.hpp"
#include "mesh/dataset.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

struct PcaOptions {
    Index num_modes = 0;  ///< 0: as many as `variance` asks for
    // A scan is mostly not quite neutral, and what the modes leave out the kernel must make up for:
    // fits with modes of all faces and of nearly all their variance end nearer to the truth.
    double variance = 0.999;      ///< share of the training variance kept, 0 .. 1
    bool all_expressions = true;  ///< false: neutral faces only
    bool align = false;           ///< move each face rigidly onto the template first
    double extension_mm = 30;     ///< over which length bending gives way to stretching, > 0
};

struct PointDistribution {
    Points mean;  ///< #V x 3, mean displacement from the template, mm
    Eigen::MatrixXf
        modes;         ///< 3#V x p, each of the length of its deviation; largest entry positive
    Vector variances;  ///< p, sample variances (divisor faces - 1), mm^2
    double variance_explained = 0;
    /// mm per axis: root mean square of what the modes of the other people leave of people left
    /// out, a fifth at a time; 0 for fewer than three people. What a new person will not be told
    /// by.
    double left_out_mm = 0;
    Index num_faces = 0;
    Index num_vertices = 0;  ///< that the faces cover
};

/// Throws Status::mismatch when the faces are not in the template's correspondence (more vertices,
/// or triangles the template has not), invalid_argument when fewer than two faces qualify. Memory:
/// one faces x faces matrix and the modes; faces are read in slices. O(faces^2 #V + faces^3).
PointDistribution train_point_distribution(const FaceDataset& faces, const TriMesh& template_mesh,
                                           const PcaOptions& options, const Context& context);

/// Continues values given at vertices 0 .. known.rows() - 1 over the rest of the mesh. Pieces of
/// the mesh without any known vertex stay at zero. Any number of columns.
Matrix extend_smoothly(const TriMesh& mesh, const Matrix& known, double length_mm,
                       const Context& context);

}  // namespace mien
