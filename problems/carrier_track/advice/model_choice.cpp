#include "problems/carrier_track/advice/model_choice.h"

#include "problems/carrier_track/advice/design_parameter_grid.h"
#include "problems/carrier_track/counting/fidelity_choice.h"
#include "ricochet/threshold.h"

namespace ricochet::studies::advice {

using namespace carrier_track;
using report::Json;

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
    choice[key] = {{"quiet", quiet_range(at_level, *answer.limit, *scan).quiet}};
  }
  return choice;
}

}  // namespace ricochet::studies::advice
