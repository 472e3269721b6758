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
  std::string family;                                   ///< as the report names it
  std::string part;                                     ///< of the plan, by name or number
  std::optional<std::int64_t> joint;                    ///< budget with which it is among "all"
  bool suite;                                           ///< `ricochet solve` knows its problems
  std::vector<std::size_t> problems = {}, silent = {};  ///< silent: see ReportedPart
};

/// The runs of an entry, as text; see view.h.
struct ViewEntry {
  std::string problems, shared;
  ViewRunsText runs;
};

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
    if (std::ranges::find(problems, problem) == problems.end()) {
      problems.push_back(problem);
      const ReportedPart* part = reported(planned.parts.front());
      if (part != nullptr && part->silent.contains(planned.problem)) {
        families_[family].silent.push_back(problem);
      }
    }
    const Cell& cell = planned.cell;
    for (const std::string& price : planned.gradient_prices) {
      cells_[{family, perturbations_.place_of(cell.perturbation), prices_.place_of(price),
              cell.budget, solvers_.place_of(cell.solver), formulations_.place_of(cell.formulation),
              planned.instances, planned.seeds}][problem] = &result;
    }
  }

  void write(const std::vector<Solver>& known, report::Results& page) const {
    Table entries{"view-entries",
                  {{"family"},
                   {"perturbation"},
                   {"price"},
                   {"budget"},
                   {"solver"},
                   {"formulation"},
                   {"instances"},
                   {"seeds"},
                   {"problems"},
                   {"shared"},
                   {"missing"},
                   {"times"},
                   {"spent"},
                   {"repeats"}}};
    std::vector<ViewOrderWriter> orders;
    std::optional<Condition> last;
    for (const auto& [common, taken] : cells_) {
      const auto& [family, perturbation, price, budget, solver, formulation, instances, seeds] =
          common;
      const Condition condition{family, perturbation, price, budget};
      if (condition != last) orders.emplace_back();
      last = condition;
      const ViewEntry entry = entry_of(family, prices_.all()[price], taken, orders.back());
      entries.add(family, perturbation, price, budget, solver, formulation, instances, seeds,
                  entry.problems, entry.shared, entry.runs.missing, entry.runs.times,
                  entry.runs.spent, entry.runs.repeats);
    }
    Table families{"view-families",
                   {{"family"}, {"part"}, {"joint"}, {"suite"}, {"problems"}, {"silent"}}};
    for (const ViewFamily& one : families_) {
      families.add(one.family, one.part, one.joint, one.suite,
                   fmt::format("{}", fmt::join(one.problems, " ")),
                   fmt::format("{}", fmt::join(one.silent, " ")));
    }
    Table problems{"view-problems",
                   {{"problem"}, {"variables"}, {"constraints"}, {"targets"}, {"cluster"}}};
    for (const ViewProblem& one : problems_) {
      problems.add(one.problem, one.variables, one.constraints, one.targets, one.cluster);
    }
    Table solvers{"view-solvers", {{"solver"}, {"outside"}}};
    for (const std::string& name : solvers_.all()) {
      solvers.add(name, std::ranges::find(known, name, &Solver::name) == known.end());
    }
    Table all_orders{"view-orders", {{"order"}}};
    for (const ViewOrderWriter& one : orders) all_orders.add(one.text());
    for (Table* table : {&entries, &families, &problems, &solvers, &all_orders}) {
      page.add(std::move(*table));
    }
    for (const auto& [name, names] :
         {std::pair{"view-formulations", &formulations_},
          std::pair{"view-perturbations", &perturbations_}, std::pair{"view-prices", &prices_}}) {
      Table list{name, {{"name"}}};
      for (const std::string& one : names->all()) list.add(one);
      page.add(std::move(list));
    }
    page.set("first_instance", campaign_.plan().first_instance);
  }

 private:
  /// Family, perturbation, price, budget: entries under one condition can be ranked.
  using Condition = std::tuple<std::size_t, std::size_t, std::size_t, std::int64_t>;
  using Taken = std::map<std::size_t, const CellResult*>;  ///< by problem

  /// Null for a part that the report has no pages of.
  const ReportedPart* reported(std::size_t part) const {
    const auto found = std::ranges::find(parts_, part, &ReportedPart::part);
    return found == parts_.end() ? nullptr : &*found;
  }

  std::size_t family_of(const Asked& asked) {
    const auto [known, fresh] = places_.try_emplace(asked, families_.size());
    if (!fresh) return known->second;
    const auto& [number, family] = asked;
    const PlanPart& part = campaign_.plan().parts[number];
    const std::string own = name_of_part(part, number);
    const ReportedPart* part_of_report = reported(number);
    const std::string name = part_of_report == nullptr ? fmt::format("{}-{}", family, own)
                                                       : part_of_report->families.at(family);
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
      problems_.push_back({problem.name, problem.dimension(), problem.constraints,
                           result.targets->size(), cluster_of(problem)});
    }
    return place;
  }

  ViewEntry entry_of(std::size_t family, const std::string& price, const Taken& taken,
                     ViewOrderWriter& order) const {
    ViewEntry entry;
    ViewRunsWriter runs;
    const std::vector<std::size_t>& problems = families_[family].problems;
    for (const std::size_t problem : problems) {
      const auto cell = taken.find(problem);
      entry.problems += cell == taken.end() ? '0' : '1';
      if (cell == taken.end()) continue;
      const CellResult& result = *cell->second;
      entry.shared += result.cell->cell.gradient_price == price ? '0' : '1';
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
    if (entry.shared.find('1') == std::string::npos) entry.shared.clear();
    entry.runs = runs.text();
    return entry;
  }

  struct ViewProblem {
    std::string problem;
    std::int64_t variables, constraints;
    std::size_t targets;
    std::string cluster;
  };

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

report::Results view_page(const Campaign& campaign, const std::vector<CellResult>& results,
                          const std::vector<ReportedPart>& parts, const std::vector<EntrySet>& sets,
                          const std::vector<Solver>& known) {
  ViewTable table(campaign, parts, sets);
  for (const CellResult& result : results) {
    if (!result.outcomes.empty()) table.add(result);
  }
  report::Results page;
  table.write(known, page);
  return page;
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
