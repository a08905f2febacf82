// The registration behind mien_registration; neutralization reads the fitted mesh from it.
#pragma once

#include <memory>
#include <string>

#include "mesh.hpp"
#include "registration/registration.hpp"

struct mien_registration : mien::abi::Object {
    static constexpr mien::abi::Tag kTag = mien::abi::Tag::registration;
    static constexpr const char* kName = "registration";
    explicit mien_registration(mien::RegistrationResult&& result);
    ~mien_registration();

    mien::RegistrationResult data;  // data.fitted has moved into `mesh`
    std::string json;
    mien_mesh* mesh = nullptr;  // one reference of our own
};
