// The object behind mien_measurement.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "handle.hpp"
#include "measure/asymmetry.hpp"

struct mien_measurement : mien::abi::Object {
    static constexpr mien::abi::Tag kTag = mien::abi::Tag::measurement;
    static constexpr const char* kName = "measurement";
    explicit mien_measurement(mien::Measurement&& result)
        : Object(kTag), data(std::move(result)), json(mien::measurement_json(data)) {}
    /// A comparison of left and right; `text` is its asymmetry_json().
    mien_measurement(mien::Asymmetry&& result, std::string text)
        : Object(kTag),
          data(std::move(result.measurement)),
          planes(std::move(result.planes)),
          json(std::move(text)) {}
    const mien::Measurement data;
    const std::optional<mien::AsymmetryPlanes> planes;
    const std::string json;
};
