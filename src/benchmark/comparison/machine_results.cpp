#include "src/benchmark/comparison/machine_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "problems/carrier_track/scene/enum_names.h"
#include "src/benchmark/analysis/rating.h"

namespace ricochet::studies::comparison {
namespace {

MachineResult result_of(const Problem& problem, const CellResult& of_cell) {
  MachineResult result{&problem};
  const Outcomes& outcomes = of_cell.outcomes;
  for (const Outcome& outcome : outcomes) {
    result.solved += outcome.solved() ? 1 : 0;
    result.cost += std::log10(
        static_cast<double>(std::max<std::int64_t>(1, evaluations_until_solved(outcome))));
    result.accuracy += share_reached(*of_cell.targets, outcome.optimality_gap());
  }
  const auto runs = static_cast<double>(outcomes.size());
  result.solved /= runs;
  result.cost /= runs;
  result.accuracy /= runs;
  return result;
}

}  // namespace

std::map<std::string, ByEntry> machine_results(const Campaign& campaign,
                                               const std::vector<CellResult>& results,
                                               const ReportedPart& part) {
  const std::int64_t budget = campaign.plan().parts[part.part].budgets.back();
  std::map<std::string, ByEntry> families;
  for (const CellResult& s : results) {
    const Cell& cell = s.cell->cell;
    const Problem& problem = campaign.problems()[s.cell->problem];
    const auto& asked = s.cell->parts;
    const bool counts = std::find(asked.begin(), asked.end(), part.part) != asked.end() &&
                        !problem.factors.empty() && cell.perturbation == part.usual.perturbation &&
                        cell.gradient_price == part.usual.gradient_price && cell.budget == budget;
    if (!counts) continue;
    const std::string& family = part.families.at(campaign.family_of(s.cell->problem));
    families[family][{cell.solver, cell.formulation}].push_back(result_of(problem, s));
  }
  return families;
}

std::map<std::string, std::vector<double>> factors_of(const ByEntry& entries) {
  std::map<std::string, std::set<double>> found;
  std::set<std::string> machines;
  for (const auto& [entry, results] : entries) {
    for (const MachineResult& result : results) {
      machines.insert(result.problem->machine);
      for (const auto& [name, value] : result.problem->factors) found[name].insert(value);
    }
  }
  std::map<std::string, std::vector<double>> factors;
  for (const auto& [name, levels] : found) {
    if (levels.size() > 1) factors[name] = {levels.begin(), levels.end()};
  }
  if (machines.size() <= factors.size()) factors.clear();
  return factors;
}

double mean_solved(const std::vector<MachineResult>& results) {
  double sum = 0;
  for (const MachineResult& result : results) sum += result.solved;
  return sum / static_cast<double>(results.size());
}

std::vector<const ByEntry::value_type*> best_first(const ByEntry& entries) {
  std::vector<const ByEntry::value_type*> order;
  for (const auto& entry : entries) order.push_back(&entry);
  std::stable_sort(order.begin(), order.end(), [](const auto* a, const auto* b) {
    return mean_solved(a->second) > mean_solved(b->second);
  });
  return order;
}

std::string name_of(const ByEntry::value_type& c) {
  return entry(c.first.first, c.first.second);
}

std::string level_name(const std::string& factor, double level) {
  if (factor != "fidelity") return fmt::format("{}", level);
  using carrier_track::Fidelity;
  return std::string(carrier_track::name_of(carrier_track::fidelity_names(),
                                            static_cast<Fidelity>(std::lround(level))));
}

}  // namespace ricochet::studies::comparison
