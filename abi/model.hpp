// The object behind mien_model.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "handle.hpp"
#include "mesh.hpp"
#include "model/deformation_model.hpp"

struct mien_model : mien::abi::Object {
    static constexpr mien::abi::Tag kTag = mien::abi::Tag::model;
    static constexpr const char* kName = "deformation model";
    explicit mien_model(std::shared_ptr<const mien::DeformationModel> data);
    ~mien_model() { mien::abi::release(mesh); }
    std::shared_ptr<const mien::DeformationModel> model;
    mien_mesh* mesh =
        nullptr;  // the template; a reference of its own, so that a host may keep it longer
    std::string json;
};
