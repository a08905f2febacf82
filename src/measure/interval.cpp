#include "measure/interval.hpp"

#include "base/error.hpp"
#include "measure/distributions.hpp"

namespace mien {

Interval normal_interval(double value, double sd, double level) {
    if (!(level > 0) || !(level < 1))
        fail(Status::invalid_argument, "a level of confidence of %g; give one between 0 and 1",
             level);
    const double half = normal_quantile(0.5 + 0.5 * level) * sd;
    return {value - half, value + half};
}

double propagated_detection_limit(double sd) {
    return 2.0 * normal_quantile(0.95) * sd;
}

}  // namespace mien
