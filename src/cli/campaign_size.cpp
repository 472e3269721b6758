#include "src/cli/campaign_size.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string_view>

namespace ricochet::cli {

using report::Json;

namespace {

/// "1 run", "2 runs".
std::string counted(std::int64_t number, std::string_view noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

}  // namespace

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
      "{} of {} on {}, at most {:.3g} evaluations{}", counted(size["runs"], "run"),
      counted(size["solvers"], "solver"), counted(size["problems"], "problem"),
      size["evaluations"].get<double>(),
      to_search > 0 ? fmt::format("; {} to be searched first", counted(to_search, "best value"))
                    : "");
}

std::string in_words(const Forecast& forecast, int cores) {
  return fmt::format("{} {} on {} core{}", forecast.at_least ? "at least" : "about",
                     duration(forecast.seconds(cores)), cores, cores == 1 ? "" : "s");
}

}  // namespace ricochet::cli
