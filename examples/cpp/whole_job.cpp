// whole_job FACE.safetensors EXPRESSIONS.safetensors SCAN.ply NEUTRAL.ply EARLIER.ply LATER.ply
// EARLIER and LATER: the same person's fitted faces of two other visits.
#include <cstdio>
#include <mien/mien.hpp>

int main(int argc, char** argv) try {
    if (argc != 7) return 2;
    const mien::Session session;
    const mien::Model face(session, argv[1]);
    const mien::ExpressionModel expressions(session, argv[2]);
    const mien::Mesh file(session, argv[3]);
    const mien::Mesh scan(session, file.positions(), file.triangles(), file.colors());
    const mien::Registration fitted(session, face, scan);
    const char* const qualities[] = {"GOOD", "DOUBTFUL", "FAILED"};
    std::printf("verdict %s %s\n", qualities[fitted.verdict().quality], fitted.json().c_str());
    const mien::Neutralization neutral(session, expressions, fitted);
    neutral.mesh().save(session, argv[4]);
    mien::MeasureOptions options;  // with intervals from how surely each vertex is known
    options.zones = {{"left", {}}, {"right", {}}};
    options.after_sd_mm = fitted.field(MIEN_REGISTRATION_STANDARD_DEVIATION_MM);
    const std::vector<mien::Position> places = face.mesh().positions();
    for (std::uint32_t v = 0; v < places.size(); ++v)
        if (places[v][0] != 0) options.zones[places[v][0] > 0 ? 0 : 1].vertices.push_back(v);
    const auto moved = mien::Measurement::volume(session, neutral.mesh(), fitted.mesh(), options);
    for (int zone = 0; zone < 2; ++zone) {
        const mien_zone_volume ml = moved.zone_volume(zone);
        std::printf("zone %s %.4f mL [%.4f, %.4f]\n", zone == 0 ? "left" : "right", ml.signed_ml,
                    ml.low95_ml, ml.high95_ml);
    }
    const mien::Mesh earlier(session, argv[5]), later(session, argv[6]);
    const mien::Visits visits(session, expressions, {earlier, fitted.mesh(), later});
    std::printf("visits %s, %s, %s\n", visits.expression(0).c_str(), visits.expression(1).c_str(),
                visits.expression(2).c_str());
    mien::RegisterOptions stopped;
    stopped.progress = [](int, double) { return false; };
    mien::Registration(session, face, scan, stopped);
} catch (const mien::Exception& failure) {
    if (failure.status() == MIEN_E_CANCELLED) return std::puts("cancelled") < 0;
    return std::fprintf(stderr, "%s\n", failure.what()), 1;
}
