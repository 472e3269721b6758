#include "src/studies/contest/machine_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "problems/carrier_track/scene/enum_names.h"
#include "src/contest/rating.h"

namespace ricochet::studies::contest {
namespace {

MachineResult result_of(const Question& question, const Outcomes& outcomes) {
  MachineResult result{&question};
  const std::vector<double> targets = targets_of(question);
  for (const Outcome& outcome : outcomes) {
    const Verdict& verdict = outcome.verdict;
    result.solved += verdict.solved ? 1 : 0;
    result.cost += std::log10(static_cast<double>(
        std::max<std::int64_t>(1, verdict.evaluations_to_solve.value_or(outcome.evaluations))));
    if (!verdict.regret) continue;
    for (const double target : targets) {
      result.accuracy += *verdict.regret <= target ? 1 / static_cast<double>(targets.size()) : 0;
    }
  }
  const auto runs = static_cast<double>(outcomes.size());
  result.solved /= runs;
  result.cost /= runs;
  result.accuracy /= runs;
  return result;
}

}  // namespace

std::map<std::string, ByCompetitor> machine_results(const Campaign& campaign,
                                                    const std::vector<StoredStanding>& standings,
                                                    const ReportedPart& part) {
  const std::int64_t budget = campaign.plan().parts[part.part].budgets.back();
  std::map<std::string, ByCompetitor> families;
  for (const StoredStanding& s : standings) {
    const Cell& cell = s.cell->cell;
    const Question& question = campaign.questions()[s.cell->question];
    const auto& asked = s.cell->parts;
    const bool counts = std::find(asked.begin(), asked.end(), part.part) != asked.end() &&
                        !question.factors.empty() && cell.feature == part.usual.feature &&
                        cell.gradient_price == part.usual.gradient_price && cell.budget == budget;
    if (!counts) continue;
    const std::string& family = part.families.at(campaign.family_of(s.cell->question));
    families[family][{cell.solver, cell.form}].push_back(result_of(question, s.outcomes));
  }
  return families;
}

std::map<std::string, std::vector<double>> factors_of(const ByCompetitor& competitors) {
  std::map<std::string, std::set<double>> found;
  std::set<std::string> machines;
  for (const auto& [competitor, results] : competitors) {
    for (const MachineResult& result : results) {
      machines.insert(result.question->machine);
      for (const auto& [name, value] : result.question->factors) found[name].insert(value);
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

std::vector<const ByCompetitor::value_type*> best_first(const ByCompetitor& competitors) {
  std::vector<const ByCompetitor::value_type*> order;
  for (const auto& competitor : competitors) order.push_back(&competitor);
  std::stable_sort(order.begin(), order.end(), [](const auto* a, const auto* b) {
    return mean_solved(a->second) > mean_solved(b->second);
  });
  return order;
}

std::string name_of(const ByCompetitor::value_type& c) {
  return competitor(c.first.first, c.first.second);
}

std::string level_name(const std::string& factor, double level) {
  if (factor != "fidelity") return fmt::format("{}", level);
  using carrier_track::Fidelity;
  return std::string(carrier_track::name_of(carrier_track::fidelity_names(),
                                            static_cast<Fidelity>(std::lround(level))));
}

}  // namespace ricochet::studies::contest
