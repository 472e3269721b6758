#include "src/analysis/comparison/view.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "src/analysis/outcomes.h"
#include "src/analysis/results.h"

namespace ricochet::studies::comparison {

namespace {

using report::Json;

/// Names in the order in which they are first asked for.
class Names {
 public:
  std::size_t place_of(const std::string& name) {
    const auto [known, fresh] = places_.try_emplace(name, names_.size());
    if (fresh) names_.push_back(name);
    return known->second;
  }
  const std::vector<std::string>& all() const { return names_; }

 private:
  std::vector<std::string> names_;
  std::map<std::string, std::size_t> places_;
};

struct ViewFamily {
  std::string family;                 ///< as the report names it
  std::string part;                   ///< of the plan, by name or number
  std::optional<std::int64_t> joint;  ///< budget with which it is among "all"
  bool suite;                         ///< `ricochet solve` knows its problems
  std::vector<std::size_t> problems = {};
};
RICOCHET_FIELDS(ViewFamily, family, part, joint, suite, problems);

struct ViewProblem {
  std::string problem;
  std::int64_t variables, constraints;
  std::size_t targets;
};
RICOCHET_FIELDS(ViewProblem, problem, variables, constraints, targets);

struct ViewSolver {
  std::string solver;
  bool outside;  ///< none of the suite: `ricochet solve` does not know it by this name
};
RICOCHET_FIELDS(ViewSolver, solver, outside);

struct ViewEntry {
  std::size_t family, perturbation, price;
  std::int64_t budget;
  std::size_t solver, formulation;
  int instances, seeds;
  std::string problems = {}, missing = {}, times = {}, spent = {}, repeats = {};
};
RICOCHET_FIELDS(ViewEntry, family, perturbation, price, budget, solver, formulation, instances,
                seeds, problems, missing, times, spent, repeats);

/// A row of the table for readers.
struct ViewContents {
  std::string family, part, variables;
  std::size_t problems, entries;
  std::string budgets, perturbations, prices;
  std::size_t runs;
};
RICOCHET_FIELDS(ViewContents, family, part, variables, problems, entries, budgets, perturbations,
                prices, runs);

/// A part of the plan, and a family by its own name.
using Asked = std::pair<std::size_t, std::string>;

/// What the runs of an entry have in common: family, perturbation, price, budget, solver,
/// formulation, instances, seeds.
using Common = std::tuple<std::size_t, std::size_t, std::size_t, std::int64_t, std::size_t,
                          std::size_t, int, int>;

/// The budget with which each family is joined with others, by the names of the report.
std::map<std::string, std::int64_t> joint_budgets(const Campaign& campaign,
                                                  const std::vector<EntrySet>& sets) {
  std::map<std::string, std::int64_t> budgets;
  if (joint_entry_set(campaign, sets).problems.empty()) return budgets;
  for (const EntrySet& set : sets) {
    if (is_joined(campaign, set)) budgets[set.family] = set.budget;
  }
  return budgets;
}

class ViewTable {
 public:
  ViewTable(const Campaign& campaign, const std::vector<ReportedPart>& parts,
            const std::vector<EntrySet>& sets)
      : campaign_(campaign), parts_(parts), joint_(joint_budgets(campaign, sets)) {}

  void add(const CellResult& result) {
    const PlannedCell& planned = *result.cell;
    const std::size_t family =
        family_of({planned.parts.front(), campaign_.family_of(planned.problem)});
    auto& problems = families_[family].problems;
    const std::size_t problem = problem_of(result);
    if (std::ranges::find(problems, problem) == problems.end()) problems.push_back(problem);
    const Cell& cell = planned.cell;
    cells_[{family, perturbations_.place_of(cell.perturbation),
            prices_.place_of(cell.gradient_price), cell.budget, solvers_.place_of(cell.solver),
            formulations_.place_of(cell.formulation), planned.instances, planned.seeds}][problem] =
        &result;
  }

  Json view(const std::vector<Solver>& known) const {
    std::vector<ViewEntry> entries;
    std::vector<ViewOrderWriter> orders;
    std::optional<Condition> last;
    for (const auto& [common, taken] : cells_) {
      const auto& [family, perturbation, price, budget, solver, formulation, instances, seeds] =
          common;
      const Condition condition{family, perturbation, price, budget};
      if (condition != last) orders.emplace_back();
      last = condition;
      entries.push_back(entry_of(common, taken, orders.back()));
    }
    const Json solvers = report::list_of(solvers_.all(), [&](const std::string& name) {
      return Json(ViewSolver{name, std::ranges::find(known, name, &Solver::name) == known.end()});
    });
    return {{"first_instance", campaign_.plan().first_instance},
            {"families", families_},
            {"problems", problems_},
            {"solvers", solvers},
            {"formulations", formulations_.all()},
            {"perturbations", perturbations_.all()},
            {"prices", prices_.all()},
            {"entries", entries},
            {"orders", report::list_of(orders, [](const auto& one) { return one.text(); })}};
  }

  Json contents() const {
    Json rows = Json::array();
    for (std::size_t family = 0; family < families_.size(); ++family) {
      rows.push_back(contents_of(family));
    }
    return rows;
  }

 private:
  /// Family, perturbation, price, budget: entries under one condition can be ranked.
  using Condition = std::tuple<std::size_t, std::size_t, std::size_t, std::int64_t>;
  using Taken = std::map<std::size_t, const CellResult*>;  ///< by problem

  std::size_t family_of(const Asked& asked) {
    const auto [known, fresh] = places_.try_emplace(asked, families_.size());
    if (!fresh) return known->second;
    const auto& [number, family] = asked;
    const PlanPart& part = campaign_.plan().parts[number];
    const std::string own = name_of_part(part, number);
    const auto reported = std::ranges::find(parts_, number, &ReportedPart::part);
    const std::string name = reported == parts_.end() ? fmt::format("{}-{}", family, own)
                                                      : reported->families.at(family);
    const auto joint = joint_.find(name);
    const bool suite =
        part.machines.around.empty() && part.drawn_machines == 0 && !part.relocated_optimum;
    families_.push_back(
        {name, own, joint == joint_.end() ? std::nullopt : std::optional(joint->second), suite});
    return known->second;
  }

  std::size_t problem_of(const CellResult& result) {
    const Problem& problem = campaign_.problems()[result.cell->problem];
    const std::size_t place = problem_names_.place_of(problem.name);
    if (place == problems_.size()) {
      problems_.push_back(
          {problem.name, problem.dimension(), problem.constraints, result.targets->size()});
    }
    return place;
  }

  ViewEntry entry_of(const Common& common, const Taken& taken, ViewOrderWriter& order) const {
    const auto& [family, perturbation, price, budget, solver, formulation, instances, seeds] =
        common;
    ViewEntry entry{.family = family,
                    .perturbation = perturbation,
                    .price = price,
                    .budget = budget,
                    .solver = solver,
                    .formulation = formulation,
                    .instances = instances,
                    .seeds = seeds};
    ViewRunsWriter runs;
    const std::vector<std::size_t>& problems = families_[family].problems;
    for (const std::size_t problem : problems) {
      const auto cell = taken.find(problem);
      entry.problems += cell == taken.end() ? '0' : '1';
      if (cell == taken.end()) continue;
      const CellResult& result = *cell->second;
      const std::vector<bool> repeated = repeats(result.outcomes);
      for (std::size_t k = 0; k < repeated.size(); ++k) {
        ViewRun run = view_run(result.outcomes[k], *result.targets);
        run.repeats = repeated[k];
        runs.add(run, result.cell->budget.evaluations);
        const bool feasible = result.outcomes[k].verdict.returned_optimality_gap.has_value();
        if (run.missing == 0 || !feasible) continue;  // the times say it, or all are equal
        order.add({problem, k, run.missing}, reached_by(result.outcomes[k]));
      }
    }
    if (taken.size() == problems.size()) entry.problems.clear();
    entry.missing = runs.text().missing;
    entry.times = runs.text().times;
    entry.spent = runs.text().spent;
    entry.repeats = runs.text().repeats;
    return entry;
  }

  ViewContents contents_of(std::size_t family) const {
    std::set<std::int64_t> budgets, variables;
    std::set<std::string> perturbations, prices;
    std::set<std::pair<std::size_t, std::size_t>> entries;
    std::size_t runs = 0;
    for (const auto& [common, taken] : cells_) {
      if (std::get<0>(common) != family) continue;
      perturbations.insert(perturbations_.all()[std::get<1>(common)]);
      prices.insert(prices_.all()[std::get<2>(common)]);
      budgets.insert(std::get<3>(common));
      entries.insert({std::get<4>(common), std::get<5>(common)});
      for (const auto& [problem, result] : taken) runs += result->outcomes.size();
    }
    for (const std::size_t problem : families_[family].problems) {
      variables.insert(problems_[problem].variables);
    }
    const ViewFamily& own = families_[family];
    return {own.family,
            own.part,
            variables.size() == 1
                ? fmt::format("{}", *variables.begin())
                : fmt::format("{} to {}", *variables.begin(), *variables.rbegin()),
            own.problems.size(),
            entries.size(),
            fmt::format("{}", fmt::join(budgets, ", ")),
            fmt::format("{}", fmt::join(perturbations, ", ")),
            fmt::format("{}", fmt::join(prices, ", ")),
            runs};
  }

  const Campaign& campaign_;
  const std::vector<ReportedPart>& parts_;
  std::map<std::string, std::int64_t> joint_;
  std::map<Asked, std::size_t> places_;
  std::vector<ViewFamily> families_;
  std::vector<ViewProblem> problems_;
  Names problem_names_, solvers_, formulations_, perturbations_, prices_;
  std::map<Common, Taken> cells_;
};

}  // namespace

Json view_data(const Campaign& campaign, const std::vector<CellResult>& results,
               const std::vector<ReportedPart>& parts, const std::vector<EntrySet>& sets,
               const std::vector<Solver>& known) {
  ViewTable table(campaign, parts, sets);
  for (const CellResult& result : results) {
    if (!result.outcomes.empty()) table.add(result);
  }
  return {{"families", table.contents()}, {"view", table.view(known)}};
}

void ViewOrderWriter::add(const RankedTogether& together, const Reached& reached) {
  std::vector<Value>& values = values_[together];
  const Value value{reached.value, reached.cost};
  const auto place = std::ranges::lower_bound(values, value);
  const bool known = place != values.end() && *place == value;
  const auto position = 2 * static_cast<std::size_t>(place - values.begin()) + (known ? 1 : 0);
  for (std::size_t weight = 1; weight <= 2 * values.size(); weight *= 2) {
    bits_.push_back((position & weight) != 0);
  }
  if (!known) values.insert(place, value);
}

std::string ViewOrderWriter::text() const {
  std::string text;
  for (std::size_t from = 0; from < bits_.size(); from += 6) {
    std::int64_t digit = 0;
    for (std::size_t bit = from; bit < std::min(from + 6, bits_.size()); ++bit) {
      if (bits_[bit]) digit += std::int64_t{1} << (bit - from);
    }
    text += view_digit(digit);
  }
  return text;
}

namespace {

constexpr std::string_view base64_digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::int64_t largest_digit = 63;

/// Appends a number >= 0, five bits a digit.
void append(std::string& text, std::int64_t number) {
  while (number >= 32) {
    text += view_digit(32 + number % 32);
    number /= 32;
  }
  text += view_digit(number);
}

}  // namespace

char view_digit(std::int64_t value) {
  return base64_digits.at(static_cast<std::size_t>(value));
}

std::int64_t targets_at(int level, std::size_t targets) {
  const auto all = static_cast<std::int64_t>(targets);
  return (all * (level + 1) + view_levels - 1) / view_levels;  // rounded up
}

ViewRun view_run(const ricochet::comparison::Outcome& outcome,
                 const ricochet::comparison::Targets& targets) {
  const auto& gap = outcome.verdict.returned_optimality_gap;
  ViewRun run;
  run.missing = gap ? std::lower_bound(targets.begin(), targets.end(), *gap) - targets.begin()
                    : static_cast<std::int64_t>(targets.size()) + 1;
  run.evaluations = outcome.evaluations;
  run.missing = outcome.solved() ? 0 : std::max<std::int64_t>(run.missing, 1);
  const std::int64_t reached = static_cast<std::int64_t>(targets.size()) - run.missing;
  const auto steps = steps_of(outcome);
  for (int level = 0; level < view_levels; ++level) {
    const std::int64_t taken = targets_at(level, targets.size());
    if (taken > reached) break;
    std::int64_t time = evaluations_until_solved(outcome);
    if (level + 1 < view_levels) {
      const double target = targets[targets.size() - static_cast<std::size_t>(taken)];
      const auto step = std::ranges::find_if(
          steps, [&](const auto& one) { return one.optimality_gap <= target; });
      if (step != steps.end()) time = std::min(time, step->evaluations);
    }
    run.times.push_back(time);
  }
  return run;
}

void ViewRunsWriter::add(const ViewRun& run, std::int64_t budget) {
  text_.missing += view_digit(std::min(run.missing, largest_digit));
  if (run.missing >= largest_digit) append(text_.missing, run.missing - largest_digit);
  std::int64_t before = 0;
  for (const std::int64_t time : run.times) {
    append(text_.times, time - before);
    before = time;
  }
  if (run.repeats) {
    append(text_.repeats, single_);
    single_ = 0;
  } else {
    ++single_;
  }
  if (run.missing == 0) return;
  if (run.evaluations == budget) {
    ++whole_;
    return;
  }
  append(text_.spent, whole_);
  const std::int64_t left = budget - run.evaluations;
  append(text_.spent, left > 0 ? 2 * left : -2 * left - 1);
  whole_ = 0;
}

}  // namespace ricochet::studies::comparison
