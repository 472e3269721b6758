#include "src/benchmark/comparison/separation_data.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "src/benchmark/comparison/share_data.h"
#include "src/benchmark/statistics/holm.h"
#include "src/benchmark/statistics/rank_sum_test.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

constexpr double solves = 0.5;  // of the runs
constexpr double significant_split = 0.05;
constexpr std::size_t fewest = 3;  // entries with a property, and without

struct Solved {
  const Solver* solver;
  std::string formulation;
  double share;
};

struct Property {
  std::string name;
  std::function<bool(const Solved&)> holds;
};

std::vector<Property> properties_of(const std::vector<Solved>& entries) {
  std::vector<Property> properties = {
      {"gradients",
       [](const Solved& entry) {
         return entry.solver->capabilities.derivatives != Capabilities::Order::value;
       }},
      {"stochastic", [](const Solved& entry) { return entry.solver->stochastic; }}};
  std::set<std::string> formulations;
  for (const Solved& entry : entries) formulations.insert(entry.formulation);
  for (const std::string& formulation : formulations) {
    properties.push_back({"formulation " + formulation, [formulation](const Solved& entry) {
                            return entry.formulation == formulation;
                          }});
  }
  return properties;
}

double mean(const std::vector<double>& shares) {
  return std::accumulate(shares.begin(), shares.end(), 0.0) / static_cast<double>(shares.size());
}

struct Split {
  std::string name;
  std::vector<double> those, others;  ///< success rates with and without the property
};

std::vector<Split> splits_of(const std::vector<Solved>& entries) {
  std::vector<Split> splits;
  for (const Property& property : properties_of(entries)) {
    Split split{property.name, {}, {}};
    for (const Solved& entry : entries) {
      (property.holds(entry) ? split.those : split.others).push_back(entry.share);
    }
    if (std::min(split.those.size(), split.others.size()) >= fewest) splits.push_back(split);
  }
  return splits;
}

}  // namespace

Json separation_data(const Comparison& comparison, std::size_t problem) {
  std::vector<Solved> entries;
  for (const CellResult& result : comparison.results) {
    const Cell& cell = result.cell->cell;
    if (result.cell->problem != problem || cell.budget != comparison.part->budgets.back()) continue;
    Share solved{};
    add_runs(solved, result);
    entries.push_back({&comparison.campaign->solvers()[result.cell->solver], cell.formulation,
                       static_cast<double>(solved.successes) / solved.trials});
  }
  Json data = {{"entries", entries.size()},
               {"solving", std::ranges::count_if(
                               entries, [](const Solved& entry) { return entry.share >= solves; })},
               {"separates", nullptr},
               {"those", nullptr},
               {"others", nullptr}};
  const std::vector<Split> splits = splits_of(entries);
  std::vector<double> p_values;
  for (const Split& split : splits) {
    p_values.push_back(rank_sum_test(split.those, split.others).p_value);
  }
  p_values = holm(p_values);
  const auto least = std::ranges::min_element(p_values);
  if (least == p_values.end() || *least >= significant_split) return data;
  const Split& split = splits[static_cast<std::size_t>(least - p_values.begin())];
  data["separates"] = split.name;
  data["those"] = mean(split.those);
  data["others"] = mean(split.others);
  return data;
}

}  // namespace ricochet::studies::comparison
