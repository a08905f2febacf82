// A small made-up study: a bumpy sheet as face, subjects with smooth shape differences, expressions
// as smooth local displacements whose amplitude varies and that depend a little on the subject.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "mesh/dataset.hpp"

namespace mien::test {

struct Study {
    int side = 14;
    int subjects = 24;
    std::vector<std::string> names = {"neutral", "open", "smile", "frown", "raise"};
    Triangles triangles;
    Points rest;

    Study() {
        rest.resize(side * side, 3);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                rest.row(y * side + x) << 10.0 * x, 10.0 * y,
                    20.0 * std::sin(0.3 * x) * std::cos(0.25 * y);
        triangles.resize(2 * (side - 1) * (side - 1), 3);
        Index row = 0;
        for (int y = 0; y + 1 < side; ++y)
            for (int x = 0; x + 1 < side; ++x) {
                const std::uint32_t a = static_cast<std::uint32_t>(y * side + x);
                const std::uint32_t s = static_cast<std::uint32_t>(side);
                triangles.row(row++) << a, a + 1, a + s;
                triangles.row(row++) << a + 1, a + s + 1, a + s;
            }
    }

    Points bump(double x, double y, double width, const Vector3& direction) const {
        Points out(rest.rows(), 3);
        for (Index i = 0; i < rest.rows(); ++i) {
            const double dx = (rest(i, 0) - x) / width, dy = (rest(i, 1) - y) / width;
            out.row(i) = std::exp(-0.5 * (dx * dx + dy * dy)) * direction.transpose();
        }
        return out;
    }

    Points neutral(int subject) const {
        std::mt19937 random(1000u + static_cast<unsigned>(subject));
        std::normal_distribution<double> normal;
        Points face = rest;
        for (int k = 0; k < 12; ++k)
            face += bump(12.0 * k, 130.0 - 11.0 * ((5 * k) % 12), 35.0 + k,
                         4.0 * normal(random) * Vector3(0.3, 0.4 * (k % 3), 1.0));
        return face;
    }

    Points face(int subject, int expression, unsigned take = 0) const {
        std::mt19937 random(77u * static_cast<unsigned>(subject) +
                            static_cast<unsigned>(expression) + 9000u * take);
        std::normal_distribution<double> normal;
        const double size = 1.0 + 0.2 * normal(random);
        switch (expression) {
            case 1:
                return neutral(subject) + bump(60, 20, 18, Vector3(0, -14 * size, 3));
            case 2:
                return neutral(subject) + bump(30, 40, 14, Vector3(-6 * size, 5, 2)) +
                       bump(90, 40, 14, Vector3(6 * size, 5, 2));
            case 3:
                return neutral(subject) + bump(60, 110, 20, Vector3(0, -5 * size, -3));
            case 4:
                return neutral(subject) + bump(60, 115, 22, Vector3(0, 8 * size, 0));
            default:
                return neutral(subject);
        }
    }

    /// Writes subjects [first, last) with every expression and opens the file.
    std::shared_ptr<const FaceDataset> dataset(int first, int last, const std::string& tag) const {
        FaceDatasetWriter writer(triangles, rest.rows(), names);
        for (int subject = first; subject < last; ++subject)
            for (int expression = 0; expression < static_cast<int>(names.size()); ++expression)
                writer.add(face(subject, expression), subject, expression);
        return written(writer, tag);
    }

    static std::string path(const std::string& tag) {
        return ::testing::TempDir() + "mien_expression_" + tag + ".safetensors";
    }

    static std::shared_ptr<const FaceDataset> written(const FaceDatasetWriter& writer,
                                                      const std::string& tag) {
        writer.save(path(tag), Context());
        auto opened = std::make_shared<FaceDataset>(FaceDataset::open(path(tag), {}, Context()));
        // Mapped already: the name is not needed any more.
        std::remove(path(tag).c_str());
        return opened;
    }
};

inline double mean_distance(const Points& a, const Points& b) {
    return (a - b).rowwise().norm().mean();
}

}  // namespace mien::test
