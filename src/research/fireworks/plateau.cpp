#include "src/research/fireworks/plateau.h"

#include <algorithm>
#include <cmath>

#include "solvers/fireworks/bare_bones_fireworks.h"
#include "solvers/fireworks/fireworks_family.h"
#include "solvers/random_search.h"
#include "src/benchmark/statistics/wilson_interval.h"
#include "src/research/fireworks/errors.h"
#include "src/research/fireworks/published.h"

namespace ricochet::studies::fireworks {
namespace {

using report::Json;

constexpr std::int64_t evaluations = 1000;

template <class OfDistance>
Problem landscape(std::string name, double target, OfDistance of_distance) {
  Problem problem;
  problem.name = std::move(name);
  problem.source = "the study of the fireworks family";
  problem.lower = Vector::Zero(1);
  problem.upper = Vector::Constant(1, 1000);
  problem.start = Vector::Constant(1, 700);
  problem.evaluate = [target, of_distance](const Vector& x) {
    return Values{of_distance(std::max({target - x[0], x[0] - target - 1, 0.0})), {}};
  };
  return problem;
}

std::vector<Solver> contenders() {
  std::vector<Solver> solvers = ricochet::fireworks::family();
  solvers.push_back(ricochet::fireworks::bare_bones_fireworks("bbfwa-10", {.sparks = 10}));
  solvers.push_back(ricochet::fireworks::bare_bones_fireworks(
      "bbfwa-10-neutral", {.sparks = 10, .neutral_moves = true}));
  solvers.push_back(random_search());
  return solvers;
}

Json cell_of(const std::vector<double>& errors) {
  const auto hits = static_cast<double>(std::count(errors.begin(), errors.end(), 0.0));
  const auto runs = static_cast<double>(errors.size());
  const Interval interval = wilson_interval(hits, runs);
  return {{"rate", hits / runs},
          {"lower", interval.lower},
          {"upper", interval.upper},
          {"other", nullptr}};
}

/// Adds the published results to ours.
void add_published(const std::string& landscape, Json& solvers) {
  for (const Json& row : published()["plateau"]["rows"]) {
    if (row["landscape"] != landscape) continue;
    for (Json& solver : solvers) {
      if (solver["solver"] != row["solver"]) continue;
      for (std::size_t k = 0; k < row["rates"].size(); ++k) {
        solver["cells"][k]["other"] = row["rates"][k];
      }
    }
  }
}

}  // namespace

Problem needle(double target) {
  return landscape("needle", target, [](double distance) { return distance > 0 ? 1.0 : 0.0; });
}

Problem logarithmic_staircase(double target) {
  return landscape("logarithmic staircase", target,
                   [](double distance) { return std::ceil(std::log2(1 + distance)); });
}

Json plateau_data(int runs) {
  const Json& targets = published()["plateau"]["targets"];
  std::vector<Entry> entries;
  for (const auto& make : {needle, logarithmic_staircase}) {
    for (const Solver& solver : contenders()) {
      for (const Json& target : targets) {
        const Problem problem = make(target.get<double>());
        entries.push_back({solver, [problem] { return problem; }});
      }
    }
  }
  const auto errors = errors_of(entries, evaluations, runs, "plateaus");
  Json landscapes = Json::array();
  std::size_t next = 0;
  for (const auto& make : {needle, logarithmic_staircase}) {
    Json solvers = Json::array();
    for (const Solver& solver : contenders()) {
      Json cells = Json::array();
      for (std::size_t k = 0; k < targets.size(); ++k) cells.push_back(cell_of(errors[next++]));
      solvers.push_back({{"solver", solver.name}, {"cells", std::move(cells)}});
    }
    const std::string name = make(0).name;
    add_published(name, solvers);
    landscapes.push_back({{"id", next == errors.size() ? "staircase" : "needle"},
                          {"landscape", name},
                          {"solvers", std::move(solvers)}});
  }
  return {{"source", published()["plateau"]["source"]},
          {"evaluations", evaluations},
          {"runs", runs},
          {"targets", targets},
          {"landscapes", std::move(landscapes)}};
}

}  // namespace ricochet::studies::fireworks
