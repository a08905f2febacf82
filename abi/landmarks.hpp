// The list behind mien_landmarks.
#pragma once

#include <string>
#include <vector>

#include "handle.hpp"
#include "mesh/landmark_file.hpp"
#include "model/landmark_names.hpp"

struct mien_landmarks : mien::abi::Object {
    static constexpr mien::abi::Tag kTag = mien::abi::Tag::landmarks;
    static constexpr const char* kName = "list of landmarks";
    explicit mien_landmarks(mien::LandmarkFile&& list, const mien::NameMatch& match = {},
                            const std::vector<std::string>& unknown = {});
    /// Throws Status::not_found for an index that the list does not have.
    const mien::Mark& at(std::uint64_t index) const;

    const mien::LandmarkFile file;
    const std::string json;
};
