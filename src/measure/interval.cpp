#include "measure/interval.hpp"

#include "base/error.hpp"
#include "measure/distributions.hpp"

namespace mien {

double minimal_detectable_change(double sd, double level) {
    if (!(level > 0) || !(level < 1))
        fail(Status::invalid_argument, "a level of confidence of %g; give one between 0 and 1",
             level);
    return normal_quantile(0.5 + 0.5 * level) * sd;
}

Interval normal_interval(double value, double sd, double level) {
    const double half = minimal_detectable_change(sd, level);
    return {value - half, value + half};
}

}  // namespace mien
