#include "problems/carrier_track/advice/model_choice.h"

#include "problems/carrier_track/advice/design_parameter_grid.h"
#include "problems/carrier_track/counting/fidelity_choice.h"
#include "ricochet/threshold.h"

namespace ricochet::studies::advice {

using namespace carrier_track;
using report::Json;

namespace {

constexpr double long_window = 30;  // turns

}  // namespace

Json model_choice(const Scene& scene, const QuietSpeed& answer) {
  const double omega = answer.fastest_quiet.value_or(answer.options.fastest);
  const bool needed = couples(at_speed(scene, omega));
  Json choice = {{"across", scene.across.has_value()},
                 {"needed", needed},
                 {"omega", omega},
                 {"along", Json()},
                 {"planar", Json()}};
  const auto scan = coarse_scan(scene, answer);
  if (!needed || !scan) return choice;
  for (const auto& [key, fidelity] :
       {std::pair{"along", Fidelity::impact}, std::pair{"planar", Fidelity::planar}}) {
    Scene at_level = scene;
    at_level.fidelity = fidelity;
    Limit limit = *answer.limit;
    if (answer.is_of_the_long_run()) {
      // The planar model has no regimes: both levels count in a window in which the start matters
      // little.
      at_level.window = Revolutions{long_window};
      limit = {Measure::collisions, long_window * (limit.at_most + 0.5)};
    }
    choice[key] = {{"quiet", quiet_range(at_level, limit, *scan).quiet}};
  }
  return choice;
}

}  // namespace ricochet::studies::advice
