// How well a network gives back faces that it encoded (kosk-2024, 3.3.10), in millimetres.
#pragma once

#include <string>
#include <vector>

#include "learning/network.hpp"
#include "mesh/dataset.hpp"

namespace mien {

/// What a method makes of a face: the same vertices, in the face's frame, mm.
using Reconstruct = std::function<Points(const Points& face)>;

struct ReconstructionErrors {
    std::vector<double> l1_mm;  ///< per face: mean over the vertices of |dx| + |dy| + |dz|
    std::vector<double> l2_mm;  ///< per face: mean distance
    std::vector<double> dame;   ///< per face, rad
    std::vector<double> fmpd;   ///< per face, 0 to 1

    static double mean(const std::vector<double>& values);
};

/// Faces of a dataset whose subject is listed (none listed: all).
std::vector<Index> chosen_faces(const FaceDataset& data, const std::vector<std::int32_t>& subjects,
                                bool neutral_only);

/// Throws Status::not_found when no face is chosen. Progress in Stage::measuring. The perceptual
/// measures cost about 0.1 s for a face of 10,000 vertices; without them `dame` and `fmpd` stay
/// empty.
ReconstructionErrors reconstruction_errors(const FaceDataset& data, const std::vector<Index>& faces,
                                           const Reconstruct& reconstruct, bool perceptual,
                                           const Context& context);

/// {"faces", "l1_mm", "l2_mm", "dame", "fmpd", "l1_mm_by_face", ...}.
std::string reconstruction_json(const ReconstructionErrors& errors);

}  // namespace mien
