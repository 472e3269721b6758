#include "src/benchmark/statistics/wilson_interval.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <stdexcept>

#include "src/benchmark/statistics/confidence.h"

namespace ricochet {

Interval wilson_interval(double successes, double trials, double confidence) {
  check_confidence(confidence);
  if (!(trials > 0 && successes >= 0 && successes <= trials)) {
    throw std::invalid_argument("wilson_interval: 0 <= successes <= trials and a trial are needed");
  }
  const double z = boost::math::quantile(boost::math::normal(), (1 + confidence) / 2);
  const double failures = trials - successes;
  const double centre = successes + z * z / 2;
  const double half = z * std::sqrt(successes * failures / trials + z * z / 4);
  // For no success or no failure one end is exactly 0 or 1, despite rounding.
  return {successes == 0 ? 0 : std::max(0.0, (centre - half) / (trials + z * z)),
          failures == 0 ? 1 : std::min(1.0, (centre + half) / (trials + z * z))};
}

}  // namespace ricochet
