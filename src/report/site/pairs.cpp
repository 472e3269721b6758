#include "src/report/site/pairs.h"

#include <fmt/format.h>

#include <algorithm>

#include "src/report/site/comparison_data.h"

namespace ricochet::site {
namespace {

struct Simulated {
  std::string family;                     ///< of problems whose answer the simulations compute
  std::vector<std::string> formulations;  ///< in which every evaluation is one simulation
  double tolerance;
  std::vector<std::string> names;  ///< of the cases
  std::vector<PairedSimulation> simulations;
};
RICOCHET_READ_FROM_JSON(Simulated, family, formulations, tolerance, names, simulations);

/// Returns the seconds of a simulation from the family's page for this budget; nothing if it is
/// missing.
std::optional<double> simulation_seconds(const FoundReport& report, const std::string& family,
                                         double budget) {
  for (const FoundPage& page : report.pages) {
    if (!holds(page.headline, "family")) continue;
    const auto data = page.data.get<FamilyData>();
    if (data.family != family) continue;
    for (const BreakEven& one : data.break_even_families) {
      if (one.budget == budget && !one.here.empty()) return one.here.front().simulation;
    }
  }
  return std::nullopt;
}

std::vector<PairedSolver> solvers_of(const FoundReport& report, const Simulated& simulated) {
  std::vector<PairedSolver> solvers;
  for (const SpeedAccuracy& one : report.data.get<ComparisonData>().speed_accuracy) {
    const bool fits = one.family == simulated.family && one.largest && one.budget &&
                      std::ranges::count(simulated.formulations, one.formulation) > 0;
    if (!fits || one.share.value_or(0) <= 0) continue;
    if (!one.seconds || !one.evaluations || !one.share_lower || !one.share_upper) continue;
    const auto simulation = simulation_seconds(report, one.family, *one.budget);
    if (!simulation) continue;
    const double own = *one.seconds - *one.evaluations * *simulation;
    solvers.push_back({one.solver, one.formulation, *one.evaluations, std::max(own, 0.0),
                       *one.share, *one.share_lower, *one.share_upper});
  }
  return solvers;
}

/// The fastest answer of the cases [rad/s].
double fastest_of(const Json& cases) {
  double fastest = 0;
  for (const Json& one : cases) {
    const Json& threshold = one.at("threshold");
    if (threshold.is_number()) fastest = std::max(fastest, threshold.get<double>());
  }
  return fastest;
}

std::string time_text(double seconds) {
  return seconds < 0.1 ? fmt::format("{:.2g} ms", 1e3 * seconds) : fmt::format("{:.2g} s", seconds);
}

}  // namespace

std::optional<Pairs> pairs_of(const FoundReport& simulating, const FoundReport& comparing) {
  auto simulated = simulating.data.at("thresholds").get<Simulated>();
  std::erase_if(simulated.simulations, [](const PairedSimulation& one) { return !one.error; });
  std::vector<PairedSolver> solvers = solvers_of(comparing, simulated);
  if (solvers.empty() || simulated.simulations.empty()) return std::nullopt;
  return Pairs{simulating.folder,   comparing.folder,
               simulated.family,    std::move(simulated.names),
               simulated.tolerance, fastest_of(simulating.data.at("thresholds").at("cases")),
               std::move(solvers),  std::move(simulated.simulations)};
}

std::vector<Pair> all_pairs(const Pairs& pairs) {
  std::vector<Pair> all;
  for (std::size_t s = 0; s < pairs.solvers.size(); ++s) {
    const PairedSolver& solver = pairs.solvers[s];
    for (std::size_t m = 0; m < pairs.simulations.size(); ++m) {
      const PairedSimulation& simulation = pairs.simulations[m];
      const double spent = solver.own + solver.evaluations * simulation.seconds;
      all.push_back({s, m, spent / solver.solved,
                     std::min(*simulation.error + pairs.tolerance, pairs.range)});
    }
  }
  return all;
}

std::vector<Pair> leading(std::vector<Pair> pairs) {
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return a.seconds != b.seconds ? a.seconds < b.seconds : a.error < b.error;
  });
  std::vector<Pair> front;
  for (const Pair& pair : pairs) {
    if (front.empty() || pair.error < front.back().error) front.push_back(pair);
  }
  return front;
}

std::vector<Pair> within_range(const Pairs& pairs) {
  const std::vector<Pair> all = all_pairs(pairs);
  std::vector<Pair> within = all;
  std::erase_if(within, [&](const Pair& pair) { return pair.error >= pairs.range; });
  return within.empty() ? all : within;
}

std::string name_of(const Pairs& pairs, const Pair& pair) {
  const PairedSimulation& simulation = pairs.simulations[pair.simulation];
  return fmt::format("{}, {}{}{}", pairs.solvers[pair.solver].solver, simulation.simulation,
                     simulation.control.empty() ? "" : " ", simulation.control);
}

std::string title_of(const Pairs& pairs) {
  const Pair best = leading(within_range(pairs)).back();
  return fmt::format("The most accurate pair is {}: {:.2g} rad/s in {}", name_of(pairs, best),
                     best.error, time_text(best.seconds));
}

std::string finding_of(const Pairs& pairs) {
  const std::vector<Pair> all = all_pairs(pairs), front = leading(within_range(pairs));
  const auto told = [&](const Pair& pair) {
    return fmt::format("{} (within {:.2g} rad/s after {})", name_of(pairs, pair), pair.error,
                       time_text(pair.seconds));
  };
  const std::string best = told(front.back());
  if (front.size() == 1) {
    return fmt::format("Of {} pairs {} is the fastest and the most accurate.", all.size(), best);
  }
  return fmt::format("Of {} pairs the most accurate is {}; the fastest is {}.", all.size(), best,
                     told(front.front()));
}

}  // namespace ricochet::site
