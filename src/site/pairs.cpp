#include "src/site/pairs.h"

#include <fmt/format.h>

#include <algorithm>

#include "src/site/answers.h"
#include "src/site/rounded.h"

namespace ricochet::site {
namespace {

constexpr const char* family = "top-speed";

bool shows_a_count(const Json& row) {
  return row.at("form") == "count" || row.at("form") == "penalised-count";
}

/// [s] of a simulation in the contest with this budget; nothing where it does not say.
Json contest_simulation(const FoundReport& contest, const Json& budget) {
  for (const Json& group : contest.data.value("groups", Json::array())) {
    if (group.at("family") != family) continue;
    for (const Json& one : group.value("break_even_families", Json::array())) {
      if (one.at("budget") == budget && !one.at("here").empty()) {
        return one["here"].front().at("simulation");
      }
    }
  }
  return nullptr;
}

Json solvers_of(const FoundReport& contest) {
  Json solvers = Json::array();
  for (const Json& row : contest.data.value("speed_accuracy", Json::array())) {
    if (row.at("family") != family || !row.at("largest").get<bool>() || !shows_a_count(row)) {
      continue;
    }
    const Json simulation = contest_simulation(contest, row.at("budget"));
    if (simulation.is_null() || row.at("share").get<double>() <= 0) continue;
    const double own = row.at("seconds").get<double>() -
                       row.at("evaluations").get<double>() * simulation.get<double>();
    solvers.push_back({{"solver", row.at("solver")},
                       {"form", row.at("form")},
                       {"evaluations", rounded(row["evaluations"])},
                       {"own", rounded(std::max(own, 0.0))},
                       {"solved", rounded(row["share"])},
                       {"solved_lower", rounded(row.at("share_lower"))},
                       {"solved_upper", rounded(row.at("share_upper"))}});
  }
  return solvers;
}

Json simulations_of(const Json& thresholds) {
  Json simulations = Json::array();
  for (const Json& row : thresholds.at("simulations")) {
    if (!row.at("error").is_number()) continue;
    simulations.push_back({{"name", row.at("simulation")},
                           {"control", row.at("control")},
                           {"reference", row.at("reference")},
                           {"seconds", rounded(row.at("seconds"))},
                           {"error", rounded(row["error"])},
                           {"error_least", rounded(row.at("error_least"))}});
  }
  return simulations;
}

std::string time_text(double seconds) {
  return seconds < 0.1 ? fmt::format("{:.2g} ms", 1e3 * seconds) : fmt::format("{:.2g} s", seconds);
}

}  // namespace

Json pairs_data(const std::vector<FoundReport>& reports) {
  const FoundReport* contest = largest_contest(reports);
  const FoundReport* dynamics = first_of(reports, "dynamics");
  if (contest == nullptr || dynamics == nullptr || !dynamics->data.contains("thresholds")) {
    return nullptr;
  }
  const Json& thresholds = dynamics->data["thresholds"];
  Json solvers = solvers_of(*contest), simulations = simulations_of(thresholds);
  if (solvers.empty() || simulations.empty()) return nullptr;
  Json cases = Json::array();
  for (const Json& one : thresholds.at("cases")) cases.push_back(one.at("case"));
  return {{"folder", dynamics->folder},
          {"contest", contest->folder},
          {"family", family},
          {"cases", std::move(cases)},
          {"tolerance", thresholds.at("tolerance")},
          {"solvers", std::move(solvers)},
          {"simulations", std::move(simulations)}};
}

std::vector<SolverSimulation> pairs_of(const Json& data) {
  const Json &solvers = data.at("solvers"), &simulations = data.at("simulations");
  const double tolerance = data.at("tolerance").get<double>();
  std::vector<SolverSimulation> pairs;
  for (std::size_t s = 0; s < solvers.size(); ++s) {
    for (std::size_t m = 0; m < simulations.size(); ++m) {
      const double spent =
          solvers[s].at("own").get<double>() +
          solvers[s].at("evaluations").get<double>() * simulations[m].at("seconds").get<double>();
      pairs.push_back({s, m, spent / solvers[s].at("solved").get<double>(),
                       simulations[m].at("error").get<double>() + tolerance});
    }
  }
  return pairs;
}

std::vector<SolverSimulation> front_of_pairs(std::vector<SolverSimulation> pairs) {
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const SolverSimulation& a, const SolverSimulation& b) {
                     return a.seconds != b.seconds ? a.seconds < b.seconds : a.error < b.error;
                   });
  std::vector<SolverSimulation> front;
  for (const SolverSimulation& pair : pairs) {
    if (front.empty() || pair.error < front.back().error) front.push_back(pair);
  }
  return front;
}

std::string name_of_pair(const Json& data, const SolverSimulation& pair) {
  const Json& simulation = data.at("simulations").at(pair.simulation);
  const auto& control = simulation.at("control").get_ref<const std::string&>();
  return fmt::format("{}, {}{}{}",
                     data.at("solvers").at(pair.solver).at("solver").get<std::string>(),
                     simulation.at("name").get<std::string>(), control.empty() ? "" : " ", control);
}

std::string pairs_title(const Json& data) {
  const SolverSimulation best = front_of_pairs(pairs_of(data)).back();
  return fmt::format("The most accurate pair is {}: {:.2g} rad/s in {}", name_of_pair(data, best),
                     best.error, time_text(best.seconds));
}

std::string pairs_finding(const Json& data) {
  const std::vector<SolverSimulation> pairs = pairs_of(data), front = front_of_pairs(pairs);
  const auto told = [&](const SolverSimulation& pair) {
    return fmt::format("{} (within {:.2g} rad/s after {})", name_of_pair(data, pair), pair.error,
                       time_text(pair.seconds));
  };
  const std::string best = told(front.back());
  if (front.size() == 1) {
    return fmt::format("Of {} pairs {} is the fastest and the most accurate.", pairs.size(), best);
  }
  return fmt::format("Of {} pairs the most accurate is {}; the fastest is {}.", pairs.size(), best,
                     told(front.front()));
}

}  // namespace ricochet::site
