#include "src/studies/simulators/study.h"

#include <fmt/format.h>

#include <algorithm>

#include "ricochet/error.h"
#include "src/studies/simulators/suite.h"

namespace ricochet::studies {

Study simulators_study(const simulators::Plan& plan) {
  if (plan.scenes < 1 || plan.scenes > 1'000'000) {
    throw InputError(fmt::format("--scenes {}: must be within 1..1000000", plan.scenes));
  }
  const auto compute = [plan](bool quick) {
    simulators::Plan chosen = plan;
    if (quick) chosen.scenes = std::min(chosen.scenes, simulators::quick_scenes);
    chosen.tool_scenes = std::min(chosen.tool_scenes, chosen.scenes);
    report::Results results;
    simulators::add_laws(results, quick ? 24 : 12);
    simulators::add_models(results, quick ? 1 : 0.1);
    simulators::add_losses(results, chosen);
    simulators::add_stiff_walls(results, quick ? 1 : 4);
    const auto said = [&](const char* name) { return text_of(*results.value(name)); };
    results.set("finding", fmt::format("{} {} {}", said("losses-finding"), said("walls"),
                                       said("laws-finding")));
    return json_of(results);
  };
  return {"simulators",
          fmt::format("A first look: {} scenes, coarser grids", simulators::quick_scenes), compute};
}

}  // namespace ricochet::studies
