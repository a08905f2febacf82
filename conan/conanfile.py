"""Conan 2 recipe of Mien: `conan create conan` from the project's root.

The library offers a C interface alone, so a shared one fits every consumer whatever its compiler's
C++ standard or standard library; its dependencies never show.
"""
import os
import re

from conan import ConanFile
from conan.tools.build import check_min_cppstd, stdcpp_library
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load

required_conan_version = ">=2.0"


class MienConan(ConanFile):
    name = "mien"
    description = "Registers, neutralizes and measures 3D face scans"
    license = "Apache-2.0"
    topics = ("mesh", "registration", "face", "3d", "c-api")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "fPIC": [True, False], "cli": [True, False], "images": [True, False]}
    default_options = {"shared": True, "fPIC": True, "cli": True, "images": True, "openmesh/*:shared": False,
                       "libpng/*:shared": False, "libjpeg-turbo/*:shared": False, "zlib/*:shared": False}

    def set_version(self):
        lists = load(self, os.path.join(self.recipe_folder, os.pardir, "CMakeLists.txt"))
        self.version = self.version or re.search(r"project\(mien VERSION ([0-9.]+)", lists).group(1)

    def export_sources(self):
        root = os.path.join(self.recipe_folder, os.pardir)
        for pattern in ("CMakeLists.txt", "LICENSE", "include/*", "src/*", "abi/*", "cmake/*"):
            copy(self, pattern, root, self.export_sources_folder)

    def config_options(self):
        if self.settings.os == "Windows":
            del self.options.fPIC

    def configure(self):
        if self.options.shared:
            self.options.rm_safe("fPIC")

    def layout(self):
        cmake_layout(self)

    def requirements(self):
        # A shared library swallows its dependencies; a static one hands OpenMesh on to the linker.
        hidden = {"transitive_headers": False, "transitive_libs": False}
        self.requires("eigen/3.4.0", **hidden)
        self.requires("nlohmann_json/3.11.2", **hidden)
        self.requires("openmesh/9.0", transitive_headers=False, transitive_libs=not self.options.shared)
        if self.options.cli:
            self.requires("cli11/2.1.2", **hidden)
        if self.options.cli or self.options.images:
            self.requires("libpng/[>=1.6.39 <2]", **hidden)
        if self.options.images:
            self.requires("libjpeg-turbo/[>=2.1.5 <4]", **hidden)
            self.requires("zlib/[>=1.2.13 <2]", **hidden)

    def validate(self):
        if self.settings.compiler.get_safe("cppstd"):
            check_min_cppstd(self, 17)

    def build_requirements(self):
        self.tool_requires("cmake/[>=3.25 <5]")

    def package_id(self):
        # The versions of what is linked in stay part of the identity: their code is inside.
        if self.info.options.shared:
            self.info.settings.compiler.rm_safe("cppstd")
            self.info.settings.compiler.rm_safe("libcxx")

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["BUILD_SHARED_LIBS"] = bool(self.options.shared)
        toolchain.cache_variables["MIEN_BUILD_CLI"] = bool(self.options.cli)
        toolchain.cache_variables["MIEN_IMAGES"] = bool(self.options.images)
        toolchain.cache_variables["MIEN_BUILD_TESTS"] = False
        toolchain.cache_variables["MIEN_BUILD_EXAMPLES"] = False
        toolchain.generate()
        CMakeDeps(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))

    def package_info(self):
        windows = self.settings.os == "Windows"
        self.cpp_info.set_property("cmake_file_name", "mien")
        self.cpp_info.set_property("cmake_target_name", "mien::mien")
        self.cpp_info.set_property("pkg_config_name", "mien")
        self.cpp_info.libs = ["mien"]
        if not self.options.shared:
            self.cpp_info.defines = ["MIEN_STATIC"]
            self.cpp_info.requires = ["openmesh::openmesh", "eigen::eigen", "nlohmann_json::nlohmann_json"]
            if self.options.cli:
                self.cpp_info.requires += ["cli11::cli11"]
            if self.options.cli or self.options.images:
                self.cpp_info.requires += ["libpng::libpng"]
            if self.options.images:
                self.cpp_info.requires += ["libjpeg-turbo::libjpeg-turbo", "zlib::zlib"]
            if not windows:
                self.cpp_info.system_libs = ["m", "pthread"]
            # A program in C does not bring it along.
            self.cpp_info.system_libs += filter(None, [stdcpp_library(self)])
