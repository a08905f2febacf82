// The objects behind mien_expression_model and mien_neutralization.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "expression/expression_model.hpp"
#include "expression/neutralize.hpp"
#include "expression/treated_readings.hpp"
#include "handle.hpp"
#include "mesh.hpp"

struct mien_expression_model : mien::abi::Object {
    static constexpr mien::abi::Tag kTag = mien::abi::Tag::expression_model;
    static constexpr const char* kName = "expression model";
    mien_expression_model(std::shared_ptr<const mien::ExpressionModel> data, std::string report)
        : Object(kTag), model(std::move(data)), json(std::move(report)) {}
    std::shared_ptr<const mien::ExpressionModel> model;
    std::string json;
};

struct mien_neutralization : mien::abi::Object {
    static constexpr mien::abi::Tag kTag = mien::abi::Tag::neutralization;
    static constexpr const char* kName = "neutralization";
    mien_neutralization() : Object(kTag) {}
    ~mien_neutralization() { mien::abi::release(mesh); }
    std::shared_ptr<const mien::TriMesh> face;  // what was neutralized
    mien_mesh* mesh = nullptr;  // a reference of its own, so that a host may keep the mesh longer
    mien::NeutralizationResult result;
    std::optional<mien::TreatedReadings> readings;  // none without a treated zone
    std::string json;
};

struct mien_evaluation : mien::abi::Object {
    static constexpr mien::abi::Tag kTag = mien::abi::Tag::evaluation;
    static constexpr const char* kName = "evaluation";
    explicit mien_evaluation(std::string report) : Object(kTag), json(std::move(report)) {}
    std::string json;
};

struct mien_series : mien::abi::Object {
    static constexpr mien::abi::Tag kTag = mien::abi::Tag::series;
    static constexpr const char* kName = "series";
    mien_series() : Object(kTag) {}
    std::shared_ptr<const mien::TriMesh> identity;
    std::vector<std::shared_ptr<const mien::TriMesh>> neutrals;
    std::string json;
};
