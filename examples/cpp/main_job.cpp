// From a raw scan to a neutral face and the volume in between, by the C++ face.
//   main_job FACE.safetensors EXPRESSIONS.safetensors SCAN.ply FITTED.ply NEUTRAL.ply
//   [NEUTRAL_FROM_FILE.ply]
// With a sixth path, the fitted face is also read back from its file and neutralized from there.
#include <cstdio>
#include <mien/mien.hpp>

int main(int argc, char** argv) {
    if (argc < 6) return 2;
    try {
        const mien::Session session;
        const mien::Model face(session, argv[1]);
        const mien::ExpressionModel expressions(session, argv[2]);
        const mien::Mesh scan(session, argv[3]);

        const mien::Registration fitted(session, face, scan);
        const mien::Neutralization neutral(session, expressions, fitted);
        fitted.mesh().save(session, argv[4]);
        neutral.mesh().save(session, argv[5]);
        const auto volume = mien::Measurement::volume(session, fitted.mesh(), neutral.mesh());
        std::printf("volume %.6f mL\n", volume.zone_volume(MIEN_ZONE_WHOLE).absolute_ml);

        if (argc > 6) {
            const mien::Mesh read_back(session, argv[4]);
            mien::Neutralization(session, expressions, read_back).mesh().save(session, argv[6]);
        }
    } catch (const mien::Exception& failure) {
        std::fprintf(stderr, "%s: %s\n", mien_status_name(failure.status()), failure.what());
        return 1;
    }
}
