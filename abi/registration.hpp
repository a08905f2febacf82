// The registration behind mien_registration; neutralization reads the fitted mesh from it.
#pragma once

#include <memory>
#include <string>

#include "mesh.hpp"
#include "registration/fit_record.hpp"
#include "registration/reference_visit.hpp"

struct mien_registration : mien::abi::Object {
    static constexpr mien::abi::Tag kTag = mien::abi::Tag::registration;
    static constexpr const char* kName = "registration";
    mien_registration(mien::RegistrationResult&& result, const std::vector<mien::Zone>& zones);
    explicit mien_registration(mien::FitRecord&& record);
    /// Tied to another visit; `kept`: as it was before.
    mien_registration(mien::TiedVisit&& tied, const mien_registration& kept);
    ~mien_registration();

    mien::RegistrationResult data;                // data.fitted has moved into `mesh`
    std::vector<mien::Zone> zones;                // of the model
    std::shared_ptr<const mien::TextureTie> tie;  // null: never tied
    std::string json;
    mien_mesh* mesh = nullptr;  // one reference of our own
};
