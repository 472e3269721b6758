#include "src/benchmark/comparison/lacking_data.h"

#include <algorithm>

#include "src/core/patterns.h"

namespace ricochet::studies::comparison {

using report::Json;

Json lacking_data(const Plan& plan, const std::vector<MissingSolver>& missing) {
  Json rows = Json::array();
  for (const MissingSolver& solver : missing) {
    const bool asked = std::ranges::any_of(
        plan.parts, [&](const PlanPart& part) { return fits_any(solver.solver, part.solvers); });
    if (asked) rows.push_back({{"solver", solver.solver}, {"library", solver.library}});
  }
  return rows;
}

}  // namespace ricochet::studies::comparison
