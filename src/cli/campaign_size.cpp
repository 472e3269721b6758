#include "src/cli/campaign_size.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <map>

namespace ricochet::cli {

using report::Json;

int cores() {
  return static_cast<int>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

std::string duration(double seconds) {
  if (seconds < 90) return fmt::format("{:.2g} s", std::max(seconds, 0.1));
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 48 * 3600) return fmt::format("{:.1f} h", seconds / 3600);
  return fmt::format("{:.1f} days", seconds / 86400);
}

Json size_of(const Campaign& campaign) {
  double evaluations = 0;
  std::map<std::string, int> features;
  for (const PlannedCell& cell : campaign.cells()) {
    evaluations += static_cast<double>(cell.budget.evaluations) * cell.instances * cell.seeds;
    ++features[cell.cell.feature];
  }
  return {{"name", campaign.plan().name},         {"questions", campaign.questions().size()},
          {"solvers", campaign.solvers().size()}, {"features", features.size()},
          {"cells", campaign.cells().size()},     {"runs", campaign.runs()},
          {"evaluations", evaluations},           {"simulations", campaign.work()}};
}

std::string in_words(const Json& size) {
  return fmt::format("{} runs of {} solvers on {} questions, at most {:.3g} evaluations",
                     size["runs"].get<std::int64_t>(), size["solvers"].get<int>(),
                     size["questions"].get<int>(), size["evaluations"].get<double>());
}

}  // namespace ricochet::cli
