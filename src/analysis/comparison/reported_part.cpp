#include "src/analysis/comparison/reported_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "ricochet/error.h"
#include "ricochet/problem.h"
#include "src/analysis/outcomes.h"
#include "src/analysis/statistics/intervals.h"
#include "src/analysis/statistics/running_time.h"
#include "src/core/names.h"

namespace ricochet::studies::comparison {

namespace {

bool asks_the_same(const PlanPart& a, const PlanPart& b) {
  return a.problems == b.problems && a.machines == b.machines && a.solvers == b.solvers &&
         a.least_variables == b.least_variables && a.most_variables == b.most_variables;
}

/// Returns the first part with the same problems for which the predicate holds; it may be this one.
template <class IsSuch>
std::optional<std::size_t> companion_of(const std::vector<PlanPart>& parts, std::size_t part,
                                        const IsSuch& is_such) {
  for (std::size_t other = 0; other < parts.size(); ++other) {
    if (asks_the_same(parts[part], parts[other]) && is_such(parts[other])) return other;
  }
  return std::nullopt;
}

std::optional<std::size_t> repetition_of(const std::vector<PlanPart>& parts, std::size_t part) {
  return companion_of(parts, part, [&](const PlanPart& other) {
    return other.seeds > 1 && other.instances == parts[part].instances &&
           other.drawn_machines == parts[part].drawn_machines && !other.relocated_optimum;
  });
}

std::optional<std::size_t> drawn_of(const std::vector<PlanPart>& parts, std::size_t part) {
  if (parts[part].drawn_machines > 0) return std::nullopt;
  return companion_of(parts, part, [](const PlanPart& other) { return other.drawn_machines > 0; });
}

/// Returns the cells of a part; there is at least one.
std::vector<const PlannedCell*> cells_of(const Campaign& campaign, std::size_t part) {
  std::vector<const PlannedCell*> cells;
  for (const PlannedCell& cell : campaign.cells()) {
    const auto& parts = cell.parts;
    if (std::find(parts.begin(), parts.end(), part) != parts.end()) cells.push_back(&cell);
  }
  return cells;
}

constexpr const char* measured_price = "measured";
constexpr const char* price_of_differences = "n";

bool asks_price(const PlanPart& part, const std::string& price) {
  return std::ranges::find(part.gradient_prices, price) != part.gradient_prices.end();
}

bool asks_several_perturbations(const std::vector<const PlannedCell*>& cells) {
  return std::any_of(cells.begin(), cells.end(), [&](const PlannedCell* cell) {
    return cell->cell.perturbation != cells.front()->cell.perturbation;
  });
}

}  // namespace

std::string usual_price(const PlanPart& part) {
  for (const char* price : {measured_price, price_of_differences}) {
    if (asks_price(part, price)) return price;
  }
  return part.gradient_prices.front();
}

std::string name_of_part(const PlanPart& part, std::size_t number) {
  return part.name.empty() ? fmt::format("part-{}", number + 1) : part.name;
}

std::vector<ReportedPart> reported_parts(const Campaign& campaign) {
  std::vector<ReportedPart> reported;
  std::set<std::string> known;
  std::set<std::size_t> companions;  // parts that only repeat another part
  const std::vector<PlanPart>& parts = campaign.plan().parts;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const auto drawn = drawn_of(parts, part);
    if (drawn && !parts[part].relocated_optimum) companions.insert(*drawn);
  }
  for (std::size_t part = 0; part < parts.size(); ++part) {
    if (companions.contains(part) || parts[part].relocated_optimum) continue;
    const auto repetition = repetition_of(parts, part);
    if (repetition) companions.insert(*repetition);
    const std::vector<const PlannedCell*> cells = cells_of(campaign, part);
    ReportedPart mine{.part = part,
                      .usual = {.part = part},
                      .repetition = repetition,
                      .drawn = drawn_of(parts, part)};
    const bool plain = std::ranges::any_of(cells, [&](const PlannedCell* cell) {
      return cell->cell.perturbation == mine.usual.perturbation;
    });
    if (!plain) mine.usual.perturbation = cells.front()->cell.perturbation;
    const PlanPart& asked = parts[part];
    mine.usual.gradient_price = usual_price(asked);
    if (mine.usual.gradient_price == measured_price && asks_price(asked, price_of_differences)) {
      mine.by_differences = mine.usual;
      mine.by_differences->gradient_price = price_of_differences;
    }
    const bool varies =
        std::ranges::any_of(asked.gradient_prices,
                            [](const std::string& price) {
                              return price != measured_price && price != price_of_differences;
                            }) ||
        !asked.smoothings.empty() || asks_several_perturbations(cells);
    const std::string suffix = name_of_part(asked, part);
    for (const PlannedCell* cell : cells) {
      const std::string& family = campaign.family_of(cell->problem);
      const bool again = known.contains(family);
      mine.families[family] = again ? fmt::format("{}-{}", family, suffix) : family;
      if (again && varies) mine.asked_again.insert(family);
    }
    for (const auto& [family, name] : mine.families) known.insert(family);
    reported.push_back(std::move(mine));
  }
  return reported;
}

}  // namespace ricochet::studies::comparison

namespace ricochet::studies {

namespace {

using namespace comparison;

/// Problems of the default comparison: the paper's, and those of 2 to 32 variables that separate
/// solvers well.
constexpr const char* default_problems =
    "count-*,top-speed-*,hard-top-speed-*,profile-count-[28]-C[14],profile-count-32-C4,"
    "design-count-C[149],robust-worst-C4";

/// Patterns of solvers, and the solvers that were added.
std::vector<std::string> solvers_of(const ComparisonOptions& options, const Catalogue& catalogue) {
  chosen_solvers(catalogue.solvers, options.solvers, "--solvers");
  std::vector<std::string> names;
  for (const Solver& solver : catalogue.solvers) names.push_back(solver.name);
  std::vector<std::string> solvers = split_patterns(options.solvers);
  for (const std::string& text : options.added_solvers) {
    const std::optional<Solver> own = catalogue.own_solver(text);
    const std::string& name = own ? own->name : text;
    const bool is_known = std::find(names.begin(), names.end(), name) != names.end();
    if (own && is_known) {
      throw InputError(
          fmt::format("--solver {}: there is another solver of its name, {}", text, name));
    }
    if (!own && !is_known) {
      throw InputError(fmt::format("--solver {}: there is no such solver; {}", text,
                                   what_instead(text, names, "`ricochet list solvers`")));
    }
    if (own) names.push_back(name);
    solvers.push_back(text);
  }
  return solvers;
}

PlanPart with_other_seeds(const PlanPart& part) {
  PlanPart again = part;
  again.budgets = {part.budgets.front()};
  again.gradient_prices = {usual_price(part)};
  again.seeds = 2;
  return again;
}

/// Returns parts that check whether the ranking is robust: with other seeds, on machines drawn
/// around the cases, and with the best point elsewhere in the box.
std::vector<PlanPart> checks_of(const PlanPart& part) {
  constexpr int most_draws = 5;  // a search takes as long as about a hundred runs
  PlanPart drawn = part;
  drawn.gradient_prices = {usual_price(part)};
  drawn.budgets = {part.budgets.back()};
  drawn.drawn_machines = std::min(part.instances, most_draws);
  drawn.instances = 1;
  PlanPart relocated = part;
  relocated.gradient_prices = {usual_price(part)};
  relocated.budgets = {part.budgets.front()};
  relocated.smoothings.clear();
  relocated.relocated_optimum = true;
  return {with_other_seeds(part), drawn, relocated};
}

bool leaves_runs(const Plan& plan, const PlanPart& part, const Catalogue& catalogue) {
  Plan alone = plan;
  alone.parts = {part};
  try {
    return Campaign(alone, catalogue).runs() > 0;
  } catch (const InputError&) {
    return false;
  }
}

void check(const ComparisonOptions& options) {
  if (options.instances < 1) {
    throw InputError(fmt::format("--instances {}: must be >= 1", options.instances));
  }
  for (std::size_t b = 0; b < options.budgets.size(); ++b) {
    if (options.budgets[b] < (b == 0 ? 1 : options.budgets[b - 1] + 1)) {
      throw InputError(fmt::format("--budget {}: must be >= 1, and rise", options.budgets[b]));
    }
  }
  ricochet::check(options.limits);
  for (const double smoothing : options.smoothings) {
    if (smoothing > 0 && std::isfinite(smoothing)) continue;
    throw InputError(fmt::format("--smoothings {}: must be finite and > 0", smoothing));
  }
}

}  // namespace

Plan comparison_plan(const ComparisonOptions& options, bool quick, const Catalogue& catalogue) {
  check(options);
  Plan plan;
  plan.name = quick ? "compare --quick" : "compare";
  plan.limits = options.limits;
  PlanPart one;
  one.gradient_prices = {measured_price, price_of_differences};
  const bool own = !options.scene.empty();
  const std::string usual = own ? "*" : default_problems;
  const std::string patterns = options.problems.empty() ? usual : options.problems;
  one.problems = split_patterns(patterns);
  one.solvers = solvers_of(options, catalogue);
  one.formulations = split_patterns(options.formulations);
  one.smoothings = options.smoothings;
  one.instances = quick ? std::min(options.instances, 2) : options.instances;
  one.most_variables = 1;
  PlanPart several = one;
  several.least_variables = 2;
  several.most_variables = PlanPart().most_variables;
  using Budgets = std::vector<std::int64_t>;
  one.budgets = quick ? Budgets{100} : Budgets{100, 1000};
  several.budgets = quick ? Budgets{20} : Budgets{20, 200};
  if (own) {
    plan.scenes = {{"scene", options.scene}};
    one.machines.around = "scene";
    if (!options.budgets.empty()) one.budgets = options.budgets;
    plan.parts = {one};
    if (!quick) plan.parts.push_back(with_other_seeds(one));
    return plan;
  }
  const std::vector<Problem> chosen =
      chosen_problems(every_problem(catalogue.families), patterns, "--problems");
  for (PlanPart& part : {std::ref(one), std::ref(several)}) {
    if (!options.budgets.empty()) part.budgets = options.budgets;
    const bool any = std::any_of(chosen.begin(), chosen.end(), [&](const Problem& problem) {
      const std::int64_t n = problem.dimension();
      return part.least_variables <= n && n <= part.most_variables;
    });
    if (!any) continue;
    plan.parts.push_back(part);
    for (const PlanPart& check : quick ? std::vector<PlanPart>() : checks_of(part)) {
      if (leaves_runs(plan, check, catalogue)) plan.parts.push_back(check);
    }
  }
  return plan;
}

}  // namespace ricochet::studies

namespace ricochet::studies::comparison {

namespace {

/// By problem.
using ByProblem = std::map<std::size_t, const CellResult*>;

/// Merit of one formulation of a solver; larger is better.
std::tuple<std::size_t, double, double> merit(const Campaign& campaign, const ByProblem& taken) {
  double share = 0;
  std::vector<double> evaluations;
  for (const auto& [problem, result] : taken) {
    const OnProblem one = on_problem(campaign, *result);
    share += one.share;
    evaluations.push_back(one.evaluations);
  }
  return {taken.size(), share, -mean_cost(evaluations)};
}

}  // namespace

bool EntrySet::any_solved() const {
  for (const Entry& entry : entries) {
    for (const CellResult* result : entry.results) {
      for (const Outcome& outcome : result->outcomes) {
        if (outcome.solved()) return true;
      }
    }
  }
  return false;
}

OnProblem on_problem(const Campaign& campaign, const CellResult& of_cell) {
  OnProblem result{0, 0, 0, 0};
  std::vector<double> optimality_gaps;
  for (const Outcome& outcome : of_cell.outcomes) {
    result.evaluations += static_cast<double>(evaluations_until_solved(outcome));
    result.seconds += seconds_until_solved(outcome);
    result.share += outcome.solved() ? 1 : 0;
    optimality_gaps.push_back(outcome.optimality_gap());
  }
  const auto runs = static_cast<double>(of_cell.outcomes.size());
  const auto& stated = campaign.problems()[of_cell.cell->problem];
  result.evaluations =
      std::max(result.evaluations / runs, 1.0) / static_cast<double>(stated.dimension());
  result.seconds /= runs;
  result.share /= runs;
  result.optimality_gap = quantile(std::move(optimality_gaps), 0.5);
  return result;
}

std::vector<std::string> clusters_of(const Campaign& campaign, const Entry& entry) {
  std::vector<std::string> clusters;
  for (const CellResult* result : entry.results) {
    clusters.push_back(cluster_of(campaign.problems()[result->cell->problem]));
  }
  return clusters;
}

double mean_cost(const std::vector<double>& costs) {
  return shifted_geometric_mean(costs, 0, 1e-6);
}

std::vector<EntrySet> entry_sets_of(const Campaign& campaign,
                                    const std::vector<CellResult>& results,
                                    const std::vector<ReportedPart>& parts) {
  using Key = std::tuple<std::size_t, std::string, std::int64_t>;
  std::map<Key, std::map<std::string, std::map<std::string, ByProblem>>> all;
  for (const CellResult& result : results) {
    const PlannedCell& cell = *result.cell;
    const std::size_t number = cell.parts.front();
    const std::string price = usual_price(campaign.plan().parts[number]);
    const bool usual = cell.cell.perturbation == "plain" && cell.is_at_price(price);
    if (!usual || result.outcomes.empty()) continue;
    const auto reported = std::ranges::find(parts, number, &ReportedPart::part);
    if (reported != parts.end() && reported->silent.contains(cell.problem)) continue;
    const Key key{number, campaign.family_of(cell.problem), cell.cell.budget};
    all[key][cell.cell.solver][cell.cell.formulation][cell.problem] = &result;
  }
  const auto largest = largest_budgets(results);
  std::vector<EntrySet> sets;
  for (const auto& [key, solvers] : all) {
    EntrySet set{std::get<1>(key), std::get<0>(key), std::get<2>(key), true, {}, {}, {}};
    std::map<std::size_t, bool> asked;
    for (const auto& [solver, formulations] : solvers) {
      for (const auto& [formulation, taken] : formulations) {
        for (const auto& [problem, result] : taken) asked[problem] = true;
      }
    }
    for (const auto& [problem, yes] : asked) {
      set.problems.push_back(problem);
      set.largest = set.largest && largest.at(problem) == set.budget;
    }
    for (const auto& [solver, formulations] : solvers) {
      const auto best = std::max_element(
          formulations.begin(), formulations.end(), [&](const auto& a, const auto& b) {
            return merit(campaign, a.second) < merit(campaign, b.second);
          });
      Entry entry{solver, best->first, {}};
      for (const auto& [problem, result] : best->second) entry.results.push_back(result);
      const bool takes_all = entry.results.size() == set.problems.size();
      (takes_all ? set.entries : set.partial).push_back(std::move(entry));
    }
    const auto part = std::find_if(parts.begin(), parts.end(), [&](const ReportedPart& reported) {
      return reported.part == set.part;
    });
    // Parts with drawn machines only serve to check whether the ranking is robust.
    const bool is_drawn = campaign.plan().parts[set.part].drawn_machines > 0;
    if (part == parts.end() && is_drawn) continue;
    if (part != parts.end()) {
      if (part->asked_again.contains(set.family)) continue;
      set.family = part->families.at(set.family);
    }
    sets.push_back(std::move(set));
  }
  return sets;
}

bool is_joined(const Campaign& campaign, const EntrySet& set) {
  return set.largest && 2 * set.entries.size() >= campaign.solvers().size();
}

EntrySet joint_entry_set(const Campaign& campaign, const std::vector<EntrySet>& sets) {
  EntrySet joint{"all", 0, 0, true, {}, {}, {}};
  std::size_t joined = 0;
  std::map<std::string, Entry> entries;
  for (const EntrySet& set : sets) {
    if (!is_joined(campaign, set)) continue;
    ++joined;
    joint.problems.insert(joint.problems.end(), set.problems.begin(), set.problems.end());
    for (const Entry& entry : set.entries) {
      Entry& mine = entries[entry.solver];
      mine.solver = entry.solver;
      mine.formulation = "the best of each";
      mine.results.insert(mine.results.end(), entry.results.begin(), entry.results.end());
    }
  }
  if (joined < 2) return {};
  for (auto& [solver, entry] : entries) {
    if (entry.results.size() == joint.problems.size()) {
      joint.entries.push_back(std::move(entry));
    }
  }
  return joint;
}

}  // namespace ricochet::studies::comparison
