#include "problems/carrier_track/check/reference_integrators/accuracy.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "problems/carrier_track/models/impact_model.h"
#include "ricochet/recording.h"

namespace ricochet::carrier_track::inline reference_integrators {
namespace {

std::vector<Impact> faster_than(double speed, const Outcome& outcome) {
  std::vector<Impact> chosen;
  std::copy_if(outcome.impacts.begin(), outcome.impacts.end(), std::back_inserter(chosen),
               [&](const Impact& impact) { return impact.speed > speed; });
  return chosen;
}

}  // namespace

int collisions(const Scene& scene, const Outcome& outcome) {
  return static_cast<int>(faster_than(scene.counting_limit, outcome).size());
}

Accuracy compare(const Scene& scene, const Outcome& outcome, const Outcome& reference) {
  Accuracy accuracy;
  const int expected = collisions(scene, reference);
  accuracy.count_difference = collisions(scene, outcome) - expected;
  accuracy.end_position_error = std::abs(outcome.end.position - reference.end.position);
  const double window = 0.5 * duration_of(scene) / std::max(expected, 1);
  const std::vector<Impact> seen = faster_than(0.5 * scene.counting_limit, outcome);
  const std::vector<Impact> real = faster_than(0.5 * scene.counting_limit, reference);
  auto s = seen.begin();
  auto r = real.begin();
  while (s != seen.end() || r != real.end()) {
    const bool both = s != seen.end() && r != real.end();
    if (both && s->wall == r->wall && std::abs(s->time - r->time) <= window) {
      if (accuracy.missed + accuracy.spurious == 0) {
        ++accuracy.matched;
        accuracy.impact_time_error =
            std::max(accuracy.impact_time_error.value_or(0.0), std::abs(s->time - r->time));
      }
      ++s;
      ++r;
    } else if (r == real.end() || (both && s->time < r->time)) {
      accuracy.spurious += (s++)->speed > scene.counting_limit;
    } else {
      accuracy.missed += (r++)->speed > scene.counting_limit;
    }
  }
  return accuracy;
}

}  // namespace ricochet::carrier_track::inline reference_integrators
