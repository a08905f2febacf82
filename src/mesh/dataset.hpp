// A study's faces in correspondence: a safetensors file with vertices f32 or f64 [s, n, 3],
// subject i32 [s], expression i32 [s], triangles u32 [m, 3]; metadata expression_names (JSON list,
// the entry "neutral" marks the neutral faces) and units.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "base/safetensors.hpp"
#include "base/types.hpp"

namespace mien {

/// Immutable; faces stay in the mapped file and are read one by one.
class FaceDataset {
  public:
    static FaceDataset open(const std::string& path, const SafetensorsReadOptions& options,
                            const Context& context);

    Index num_faces() const { return num_faces_; }
    Index num_vertices() const { return num_vertices_; }
    const Triangles& triangles() const { return triangles_; }
    int subject(Index face) const { return subject_[static_cast<std::size_t>(face)]; }
    int expression(Index face) const { return expression_[static_cast<std::size_t>(face)]; }
    const std::vector<std::string>& expression_names() const { return expression_names_; }
    int neutral_expression() const { return neutral_; }  ///< index into the names, or -1
    const std::string& units() const { return units_; }

    /// Copies face k, #V x 3, into `out` (resized), scaled to millimetres.
    void face(Index k, Points& out) const;
    /// Lets go of the memory that face k's part of the mapped file takes: for passes over sets that
    /// are larger than memory. The face can be read again at any time.
    void release_face(Index k) const;
    /// Raw access for streaming training: f32 or f64 row-major [s, n, 3].
    const TensorView& vertices() const { return vertices_; }

  private:
    TensorView vertices_;
    Triangles triangles_;
    std::vector<int> subject_, expression_;
    std::vector<std::string> expression_names_;
    std::string units_;
    int neutral_ = -1;
    double to_mm_ = 1.0;
    Index num_faces_ = 0, num_vertices_ = 0;
    bool mapped_ = false;  ///< vertices_ lies in the file's mapping, not in a copy
    std::shared_ptr<const void> storage_;
};

/// Collects faces for a new dataset file.
class FaceDatasetWriter {
  public:
    FaceDatasetWriter(Triangles triangles, Index num_vertices,
                      std::vector<std::string> expression_names);
    void add(const PointsRef& vertices_mm, int subject, int expression);
    void save(const std::string& path, const Context& context) const;  ///< float32, atomic

  private:
    Triangles triangles_;
    Index num_vertices_;
    std::vector<std::string> expression_names_;
    std::vector<float> vertices_;
    std::vector<std::int32_t> subject_, expression_;
};

}  // namespace mien
