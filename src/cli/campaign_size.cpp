#include "src/cli/campaign_size.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <map>

namespace ricochet::cli {

using report::Json;

std::string duration(double seconds) {
  if (seconds < 90) return fmt::format("{:.2g} s", std::max(seconds, 0.1));
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 48 * 3600) return fmt::format("{:.1f} h", seconds / 3600);
  return fmt::format("{:.1f} days", seconds / 86400);
}

Json size_of(const Campaign& campaign) {
  double evaluations = 0;
  std::map<std::string, int> perturbations;
  for (const PlannedCell& cell : campaign.cells()) {
    evaluations += static_cast<double>(cell.budget.evaluations) * cell.instances * cell.seeds;
    ++perturbations[cell.cell.perturbation];
  }
  return {{"name", campaign.plan().name},
          {"problems", campaign.problems().size()},
          {"solvers", campaign.solvers().size()},
          {"perturbations", perturbations.size()},
          {"cells", campaign.cells().size()},
          {"runs", campaign.runs()},
          {"evaluations", evaluations},
          {"simulations", campaign.work()},
          {"to_search", campaign.to_search().size()}};
}

std::string in_words(const Json& size) {
  const auto to_search = size["to_search"].get<int>();
  return fmt::format(
      "{} runs of {} solvers on {} problems, at most {:.3g} evaluations{}",
      size["runs"].get<std::int64_t>(), size["solvers"].get<int>(), size["problems"].get<int>(),
      size["evaluations"].get<double>(),
      to_search > 0 ? fmt::format("; {} best values to be searched first", to_search) : "");
}

std::string in_words(const Forecast& forecast, int cores) {
  return fmt::format("{} {} on {} core{}", forecast.at_least ? "at least" : "about",
                     duration(forecast.seconds(cores)), cores, cores == 1 ? "" : "s");
}

}  // namespace ricochet::cli
