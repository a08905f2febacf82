// What changed in a face between visits, with intervals:
//   visits FACE.safetensors EXPRESSIONS.safetensors SCAN.ply ...
#include <cstdio>
#include <mien/mien.hpp>

int main(int argc, char** argv) {
    if (argc < 5) return 2;
    try {
        const mien::Session session;
        const mien::Model face(session, argv[1]);
        const mien::ExpressionModel expressions(session, argv[2]);
        std::vector<mien::Registration> fits;
        for (int k = 3; k < argc; ++k)
            fits.emplace_back(session, face, mien::Mesh(session, argv[k]));
        const mien::Study study(session, fits, &expressions);
        for (std::int32_t visit = 1; visit < study.visit_count(); ++visit)
            for (std::int32_t zone = 0; zone < study.zone_count(); ++zone) {
                const mien_study_value ml = study.change(0, visit, zone).signed_ml;
                std::printf("%d %-24s %11.6f %11.6f %11.6f %11.6f\n", static_cast<int>(visit),
                            study.zone_name(zone).c_str(), ml.value, ml.low, ml.high,
                            ml.limit_of_detection);
            }
    } catch (const mien::Exception& failure) {
        std::fprintf(stderr, "%s: %s\n", mien_status_name(failure.status()), failure.what());
        return 1;
    }
}
