#include "src/benchmark/comparison/comparison_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "ricochet/error.h"
#include "ricochet/families.h"
#include "src/benchmark/analysis/chosen.h"
#include "src/core/near_names.h"
#include "src/core/patterns.h"

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
  again.seeds = 2;
  return again;
}

/// Returns parts that check whether the ranking is robust: with other seeds, on machines drawn
/// around the cases, and with the best point elsewhere in the box.
std::vector<PlanPart> checks_of(const PlanPart& part) {
  constexpr int most_draws = 5;  // a search takes as long as about a hundred runs
  PlanPart drawn = part;
  drawn.budgets = {part.budgets.back()};
  drawn.drawn_machines = std::min(part.instances, most_draws);
  drawn.instances = 1;
  PlanPart relocated = part;
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
