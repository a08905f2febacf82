// Meshes that nobody would scan, and a folder of those that somebody did.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <string>
#include <vector>

#include "endurance.hpp"

namespace endurance {
namespace {

struct Crafted {
    std::string name;
    std::vector<double> positions;
    std::vector<std::uint32_t> triangles;
};

Crafted fan(std::uint32_t size) {
    Crafted mesh{"a fan of " + std::to_string(size), {0, 0, 0}, {}};
    for (std::uint32_t k = 0; k <= size; ++k) {
        const double angle = 6.0 * k / size;
        mesh.positions.insert(mesh.positions.end(), {60 * std::cos(angle), 60 * std::sin(angle),
                                                     5 * std::sin(3 * angle)});
        if (k > 0) mesh.triangles.insert(mesh.triangles.end(), {0, k, k + 1});
    }
    return mesh;
}

Crafted sheet(std::uint32_t side, const char* name) {
    Crafted mesh{name, {}, {}};
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x)
            mesh.positions.insert(
                mesh.positions.end(),
                {150.0 * x / side, 150.0 * y / side, 9 * std::sin(0.1 * x) * std::cos(0.1 * y)});
    for (std::uint32_t y = 0; y + 1 < side; ++y)
        for (std::uint32_t x = 0; x + 1 < side; ++x) {
            const std::uint32_t a = y * side + x;
            mesh.triangles.insert(mesh.triangles.end(),
                                  {a, a + 1, a + side + 1, a, a + side + 1, a + side});
        }
    return mesh;
}

std::vector<Crafted> crafted_meshes(bool whole) {
    std::vector<Crafted> meshes;
    meshes.push_back(fan(whole ? 100000 : 20000));
    const std::uint32_t side = whole ? 150 : 60;
    for (const double far : {1e6, 1e9, 1e12}) {
        meshes.push_back(sheet(side, "a sheet with a far vertex"));
        for (int k = 0; k < 3; ++k)
            meshes.back().positions[meshes.back().positions.size() - 3 + k] = far;
    }
    meshes.push_back(sheet(side, "needles"));
    for (std::size_t i = 1; i < meshes.back().positions.size(); i += 3)
        meshes.back().positions[i] *= 1e-7;
    meshes.push_back(sheet(side, "all points equal"));
    std::fill(meshes.back().positions.begin(), meshes.back().positions.end(), 3.0);
    meshes.push_back(sheet(side, "all points on a line"));
    for (std::size_t i = 0; i < meshes.back().positions.size(); ++i)
        if (i % 3 != 0) meshes.back().positions[i] = 0;
    meshes.push_back(sheet(side, "every triangle four times"));
    for (int k = 0; k < 2; ++k) {
        const std::vector<std::uint32_t> once = meshes.back().triangles;
        meshes.back().triangles.insert(meshes.back().triangles.end(), once.begin(), once.end());
    }
    meshes.push_back(sheet(side, "half of the points in one place"));
    for (std::size_t i = 0; i < meshes.back().positions.size() / 2; ++i)
        meshes.back().positions[i] = 1;
    meshes.push_back(sheet(side, "tiny"));
    for (double& x : meshes.back().positions) x *= 1e-12;
    meshes.push_back(sheet(side, "points without triangles"));
    meshes.back().triangles.clear();
    if (whole) meshes.push_back(sheet(2237, "ten million triangles"));
    return meshes;
}

constexpr double kLimitSeconds = 60;  // of computing, for one call

/// Puts one mesh through the library: each call ends, with a result or an error, within its time.
class Trial {
  public:
    Trial() : session_(new_session(kLimitSeconds)) {}
    ~Trial() { mien_session_release(session_); }
    Trial(const Trial&) = delete;
    Trial& operator=(const Trial&) = delete;

    mien_session* session() const { return session_; }
    long calls() const { return calls_; }

    /// Times one call and judges how it ended. True when it succeeded.
    template <typename Body>
    bool call(const std::string& name, const char* what, Body&& body) {
        mien_error error = {};
        error.struct_size = sizeof error;
        const std::clock_t begin = std::clock();
        const mien_status status = body(&error);
        const double taken = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
        ++calls_;
        std::printf("%-40s %-20s %-24s %7.2f s\n", name.c_str(), what, mien_status_name(status),
                    taken);
        std::fflush(stdout);
        if (status == MIEN_E_TIME_LIMIT || taken > kLimitSeconds)
            fault(name + ": " + what + " takes too long");
        if (status == MIEN_E_INTERNAL) fault(name + ": " + what + ": " + error.message);
        if (status != MIEN_OK && error.message[0] == '\0')
            fault(name + ": " + what + " fails without a message");
        return status == MIEN_OK;
    }

    void use(const std::string& name, const mien_mesh* mesh, bool large) {
        call(name, "area", [&](mien_error* e) {
            double area = 0;
            return mien_measure_area(session_, mesh, nullptr, &area, e);
        });
        call(name, "closest distance", [&](mien_error* e) {
            mien_measurement* m = nullptr;
            const mien_status s =
                mien_measure_surface_distance(session_, mesh, mesh, nullptr, &m, e);
            mien_measurement_release(m);
            return s;
        });
        call(name, "save",
             [&](mien_error* e) { return mien_mesh_save(session_, mesh, "crafted.ply", e); });
        call(name, "load", [&](mien_error* e) {
            mien_mesh* again = nullptr;
            const mien_status s = mien_mesh_load(session_, "crafted.ply", &again, e);
            mien_mesh_release(again);
            return s;
        });
        if (!large) use_slowly(name, mesh);
    }

  private:
    void use_slowly(const std::string& name, const mien_mesh* mesh) {
        call(name, "curvature", [&](mien_error* e) {
            mien_measurement* m = nullptr;
            const mien_status s = mien_measure_curvature(session_, mesh, 6, 0, nullptr, &m, e);
            mien_measurement_release(m);
            return s;
        });
        call(name, "quadric hierarchy", [&](mien_error* e) {
            mien_hierarchy* h = nullptr;
            const mien_status s = mien_hierarchy_build_quadric(session_, mesh, 2, 4, &h, e);
            mien_hierarchy_release(h);
            return s;
        });
        call(name, "register", [&](mien_error* e) {
            mien_registration* r = nullptr;
            const auto* model = static_cast<const mien_model*>(fixtures_.handle("mien_model"));
            const mien_status s = mien_register(session_, model, mesh, nullptr, &r, e);
            mien_registration_release(r);
            return s;
        });
    }

    Fixtures fixtures_;
    mien_session* session_;
    long calls_ = 0;
};

}  // namespace

void run_crafted(bool whole) {
    Trial trial;
    for (const Crafted& crafted : crafted_meshes(whole)) {
        mien_mesh_arrays arrays;
        mien_mesh_arrays_init(&arrays, sizeof arrays);
        arrays.positions = {crafted.positions.data(), crafted.positions.size() / 3, 0,
                            MIEN_DTYPE_F64, 0};
        arrays.triangles = crafted.triangles.empty() ? nullptr : crafted.triangles.data();
        arrays.triangle_count = crafted.triangles.size() / 3;
        mien_mesh* mesh = nullptr;
        const bool made = trial.call(crafted.name, "create", [&](mien_error* e) {
            return mien_mesh_create(trial.session(), &arrays, &mesh, e);
        });
        if (made) trial.use(crafted.name, mesh, crafted.positions.size() > 3000000);
        mien_mesh_release(mesh);
    }
    std::printf("%ld calls on crafted meshes\n", trial.calls());
}

void run_corpus(const std::string& folder) {
    Trial trial;
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    long read = 0;
    for (const std::filesystem::path& path : paths) {
        const std::string name = path.filename().string();
        mien_mesh* mesh = nullptr;
        const bool made = trial.call(name, "load", [&](mien_error* e) {
            return mien_mesh_load(trial.session(), path.string().c_str(), &mesh, e);
        });
        if (made) trial.use(name, mesh, std::filesystem::file_size(path) > 50000000);
        read += made;
        mien_mesh_release(mesh);
    }
    std::printf("%zu files, %ld read, %ld calls\n", paths.size(), read, trial.calls());
}

}  // namespace endurance
