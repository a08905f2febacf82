// Bytes of a small network file, written by hand as its format says: pick every second vertex, one
// dense layer to the code, and back. For tests that see the shared library alone.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace mien_test {

class SmallNetwork {
  public:
    /// Faces like `positions` (x y z of each vertex, mm), `code` numbers. The decoder's weights are
    /// the encoder's transposed, so faces near the mean come back nearly.
    SmallNetwork(const std::vector<double>& positions, const std::vector<std::uint32_t>& triangles,
                 std::uint64_t code) {
        const std::uint64_t n = positions.size() / 3, kept = (n + 1) / 2;
        double least[3], greatest[3];
        for (std::size_t c = 0; c < 3; ++c) least[c] = greatest[c] = positions[c];
        for (std::size_t k = 0; k < positions.size(); ++k) {
            least[k % 3] = std::fmin(least[k % 3], positions[k]);
            greatest[k % 3] = std::fmax(greatest[k % 3], positions[k]);
        }
        std::vector<double> mean(positions), scaled(positions), ones(positions.size(), 1);
        double scale = 0;
        for (std::size_t k = 0; k < mean.size(); ++k) {
            mean[k] -= 0.5 * (least[k % 3] + greatest[k % 3]);
            scale = std::fmax(scale, std::fabs(mean[k]));
        }
        for (std::size_t k = 0; k < mean.size(); ++k) scaled[k] = mean[k] / scale;
        std::vector<std::uint32_t> index;
        for (std::uint32_t v = 0; v < n; v += 2) index.push_back(v);
        std::vector<float> down, up, zeros(static_cast<std::size_t>(3 * n), 0.0f);
        for (std::uint64_t k = 0; k < 3 * kept * code; ++k)
            down.push_back(static_cast<float>(0.05 * std::sin(0.7 * static_cast<double>(k))));
        for (std::uint64_t k = 0; k < 3 * n * code; ++k)
            up.push_back(static_cast<float>(0.05 * std::cos(0.3 * static_cast<double>(k))));
        add("input.mean_shape", "F64", {n, 3}, mean);
        add("input.scale_mm", "F64", {1}, std::vector<double>{scale});
        for (const char* name : {"mean", "deviation", "least", "greatest"})
            add(std::string("input.") + name, "F64", {n, 3},
                std::string(name) == "deviation" ? ones : scaled);
        // A distribution of codes with two directions.
        const auto numbers = static_cast<std::size_t>(code);
        std::vector<double> factor(2 * numbers, 0.0);
        factor.front() = factor.back() = 0.5;
        add("codes.mean", "F64", {code}, std::vector<double>(numbers, 0.25));
        add("codes.factor", "F64", {2, code}, factor);
        add("input.triangles", "U32", {triangles.size() / 3, 3}, triangles);
        add("index", "U32", {kept}, index);
        add("down", "F32", {3 * kept, code}, down);
        add("up", "F32", {code, 3 * n}, up);
        add("zero_code", "F32", {code}, std::vector<float>(static_cast<std::size_t>(code)));
        add("zero_face", "F32", {3 * n}, zeros);
        layers_ =
            "{\"encoder\":[" + layer("pick", n, 3, kept, 3, false, "\"index\":\"index\"") + "," +
            layer("dense", kept, 3, 1, code, true, "\"weight\":\"down\",\"bias\":\"zero_code\"") +
            "],\"decoder\":[" +
            layer("dense", 1, code, n, 3, false, "\"weight\":\"up\",\"bias\":\"zero_face\"") + "]}";
    }

    /// A safetensors file without a hash.
    std::string bytes() const {
        std::string quoted;
        for (const char c : layers_) quoted += c == '"' ? std::string("\\\"") : std::string(1, c);
        std::string header =
            "{\"__metadata__\":{\"kind\":\"mien-network\",\"format\":\"1.0\","
            "\"units\":\"millimetres\",\"name\":\"small\","
            "\"input.features\":\"euclidean_standardised\",\"layers\":\"" +
            quoted + "\"}" + tensors_ + "}";
        while (header.size() % 8 != 0) header += ' ';
        std::string file;
        for (int k = 0; k < 8; ++k) file += static_cast<char>(header.size() >> (8 * k) & 255);
        return file + header + data_;
    }

  private:
    static std::string layer(const char* kind, std::uint64_t rows_in, std::uint64_t in,
                             std::uint64_t rows_out, std::uint64_t out, bool elu,
                             const char* tensors) {
        return std::string("{\"kind\":\"") + kind + "\",\"rows_in\":" + std::to_string(rows_in) +
               ",\"channels_in\":" + std::to_string(in) +
               ",\"rows_out\":" + std::to_string(rows_out) +
               ",\"channels_out\":" + std::to_string(out) + ",\"elu\":" + (elu ? "true" : "false") +
               ",\"tensors\":{" + tensors + "}}";
    }
    template <typename T>
    void add(const std::string& name, const char* dtype, const std::vector<std::uint64_t>& shape,
             const std::vector<T>& values) {
        std::string sizes;
        for (const std::uint64_t size : shape)
            sizes += (sizes.empty() ? "" : ",") + std::to_string(size);
        const std::size_t begin = data_.size();
        data_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
        tensors_ += ",\"" + name + "\":{\"dtype\":\"" + dtype + "\",\"shape\":[" + sizes +
                    "],\"data_offsets\":[" + std::to_string(begin) + "," +
                    std::to_string(data_.size()) + "]}";
    }
    std::string layers_, tensors_, data_;
};

}  // namespace mien_test
