#include "src/experiment/campaign.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "ricochet/error.h"
#include "src/core/instance.h"
#include "src/core/names.h"
#include "src/experiment/planned_runs.h"

namespace ricochet {

namespace {

constexpr double most_machines = 1e4;

/// What a plan may have at most, and what one of them takes before the first run.
struct Countable {
  const char* what;
  double most, kilobytes, microseconds;
};

// Measured on an AMD EPYC as the largest resident memory and the processor time of `run` until the
// first run was stored. Runs: 500,000 and a million of hs-1, on 1000 instances. Instances: 200,000
// of count-C1; one of hs-1 takes 2.9 kB and 7 us, one of profile-count-32-C4 56 kB and 110 us.
constexpr Countable runs_of_plan{"runs", 5e6, 0.4, 1};
constexpr Countable instances_of_plan{"instances of problems", 2e5, 14, 23};

/// Throws InputError if a part of a plan, or all, has too many.
void check_number(double number, const Countable& of, const std::string& place) {
  if (number <= of.most) return;
  throw InputError(fmt::format(
      "{}: {:.3g} {}: must be at most {:.0f}; so many would take about {:.2g} GB of memory and "
      "{:.2g} s before the first run: cut the plan into several",
      place, number, of.what, of.most, number * of.kilobytes / 1e6,
      number * of.microseconds / 1e6));
}

/// Throws InputError for a level that a key of the grid does not allow; without texts it allows
/// numbers >= 0.
void check_level(const std::string& key, const OptionValue& level,
                 const std::vector<std::string>& texts, const std::string& place) {
  const auto* number = std::get_if<double>(&level);
  if (texts.empty() ? number != nullptr && *number >= 0
                    : number == nullptr && std::find(texts.begin(), texts.end(),
                                                     std::get<std::string>(level)) != texts.end()) {
    return;
  }
  throw InputError(fmt::format(
      "{}: {} = {}: must be {}", place, key, text_of(level),
      texts.empty() ? "numbers >= 0" : fmt::format("\"{}\"", fmt::join(texts, "\", \""))));
}

/// Throws InputError if the grid has a key or level that is not allowed.
void check_levels(const MachineGrid& grid, const Catalogue& catalogue, const std::string& place) {
  std::vector<std::string> known;
  for (const auto& [key, texts] : catalogue.grid_keys) known.push_back(key);
  for (const auto& [key, levels] : grid.levels) {
    const auto allowed = catalogue.grid_keys.find(key);
    if (allowed == catalogue.grid_keys.end()) {
      throw InputError(
          fmt::format("{}: there is no key {}; {}", place, key, what_instead(key, known)));
    }
    for (const OptionValue& level : levels) check_level(key, level, allowed->second, place);
  }
}

/// Throws InputError if the grid has too many machines; before they are made.
void check_size(const MachineGrid& grid, const std::string& place) {
  double machines = 1;
  for (const auto& [key, values] : grid.levels) machines *= static_cast<double>(values.size());
  if (machines <= most_machines) return;
  throw InputError(fmt::format("{}: {:.3g} combinations: must be at most {:.0f}", place, machines,
                               most_machines));
}

/// The problems for the grid of a part. Throws InputError with the grid's place.
std::vector<SearchedProblem> problems_of_grid(MachineGrid grid, const Plan& plan,
                                              const Catalogue& catalogue,
                                              const std::string& place) {
  for (const PlanScene& scene : plan.scenes) {
    if (scene.name == grid.around) grid.scene = scene.text;
  }
  check_levels(grid, catalogue, place);
  check_size(grid, place);
  try {
    return catalogue.grid_problems(grid);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", place, error.what()));
  }
}

/// Throws InputError for a pattern that matches none of the names.
void check_patterns(const std::vector<std::string>& patterns, const std::vector<std::string>& names,
                    const std::string& place, const std::string& listing = "") {
  for (const std::string& pattern : patterns) require_fit({pattern}, names, place, listing);
}

std::vector<Formulation> formulations_of(const Problem& problem, const PlanPart& part) {
  std::vector<Formulation> formulations = problem.formulations(part.smoothings);
  std::erase_if(formulations, [&](const Formulation& f) {
    // A surrogate already moves the optimum.
    return !fits_any(problem.name_of(f), part.formulations) ||
           (part.relocated_optimum && f.smoothing > 0);
  });
  return formulations;
}

std::optional<std::int64_t> gradient_price_of(const std::string& price, const Problem& problem) {
  if (price == "n") return std::nullopt;
  if (price == "measured") return problem.gradient_cost;
  return std::stoll(price);
}

/// Whether what the solver is charged depends on the price of a gradient. A user's solver may ask
/// for gradients that it does not need.
bool pays_for_gradients(const Solver& solver) {
  const Capabilities& needs = solver.capabilities;
  return needs.derivatives != Capabilities::Order::value || needs.needs_residuals ||
         !solver.content.empty();
}

template <class Entry>
void add_once(std::vector<Entry>& entries, const Entry& entry) {
  if (std::ranges::find(entries, entry) == entries.end()) entries.push_back(entry);
}

bool asks_for(const PlanPart& part, const Problem& problem) {
  return is_chosen(problem, part.problems) && part.takes(problem.dimension(), problem.constraints);
}

/// What is done to a problem before it is shown to solvers.
struct PartPerturbation {
  std::string name;
  const Perturbation* perturbation;  ///< null if the optimum is relocated

  bool applies(const Problem& problem) const {
    return perturbation != nullptr ? perturbation->applies(problem) : can_be_relocated(problem);
  }
  /// The perturbed problem, to see which solvers take it.
  Problem perturbed(const Problem& problem) const {
    return perturbation != nullptr ? perturbation->perturbed(problem, 0) : problem;
  }
};

std::vector<PartPerturbation> perturbations_of(const PlanPart& part, const std::string& place) {
  std::vector<PartPerturbation> chosen;
  if (part.relocated_optimum) {
    for (const std::string& name : names_of_places()) chosen.push_back({name, nullptr});
    return chosen;
  }
  std::vector<std::string> names;
  for (const Perturbation& perturbation : all_perturbations()) {
    names.push_back(perturbation.name);
    if (fits_any(perturbation.name, part.perturbations))
      chosen.push_back({perturbation.name, &perturbation});
  }
  check_patterns(part.perturbations, names, place + ", perturbations");
  return chosen;
}

/// The catalogue with the plan's varied solvers after those of the suite.
Catalogue with_varied_solvers(Catalogue catalogue, const Plan& plan) {
  for (const VariedSolver& varied : plan.solvers) {
    const std::string place = "solver " + varied.name;
    for (const Solver& solver : catalogue.solvers) {
      if (solver.name != varied.name) continue;
      throw InputError(place + ": there is another solver of its name");
    }
    try {
      catalogue.solvers.push_back(catalogue.varied_solver(varied));
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", place, error.what()));
    }
  }
  return catalogue;
}

}  // namespace

Campaign::Campaign(Plan plan, const Catalogue& catalogue, const AllFindings& found)
    : plan_(std::move(plan)), found_(found) {
  const Catalogue whole = with_varied_solvers(catalogue, plan_);
  for (std::size_t part = 0; part < plan_.parts.size(); ++part) add_part(part, whole);
  check_number(static_cast<double>(runs()), runs_of_plan, "all parts");
}

std::size_t Campaign::index_of(const Problem& problem, const std::string& family) {
  const auto [place, fresh] = problem_places_.try_emplace(problem.name, problems_.size());
  if (fresh) {
    problems_.push_back(problem);
    families_.push_back(family);
  }
  return place->second;
}

std::size_t Campaign::index_of(const Solver& solver) {
  const auto [place, fresh] = solver_places_.try_emplace(solver.name, solvers_.size());
  if (fresh) solvers_.push_back(solver);
  return place->second;
}

void Campaign::add_searched(std::vector<Chosen>& chosen, const SearchedProblem& problem) {
  const std::string& name = problem.problem.name;
  const auto found = found_.find(name);
  if (found == found_.end()) {
    to_search_.try_emplace(name, problem);
    chosen.push_back({problem.problem, problem.family});
  } else if (!found->second.empty()) {
    chosen.push_back({problem.with(found->second), problem.family});
  }
}

std::vector<Campaign::Chosen> Campaign::problems_of(const PlanPart& part,
                                                    const Catalogue& catalogue,
                                                    const std::string& place) {
  std::vector<Chosen> chosen;
  std::vector<std::string> names;
  if (!part.machines.around.empty()) {
    for (const SearchedProblem& problem :
         problems_of_grid(part.machines, plan_, catalogue, place + ", machines")) {
      names.push_back(problem.problem.name);
      if (asks_for(part, problem.problem)) add_searched(chosen, problem);
    }
    check_patterns(part.problems, names, place + ", problems", "`ricochet list problems`");
    return chosen;
  }
  double drawn_in_all = 0;
  for (const Family& family : catalogue.families) {
    for (const Problem& problem : family.problems) {
      if (!problem.best_known) continue;
      names.push_back(problem.name);
      if (!asks_for(part, problem)) continue;
      drawn_in_all += part.drawn_machines;
      if (drawn_in_all > most_machines) {
        throw InputError(
            fmt::format("{}, drawn_machines = {}: {:.0f} problems and more: must be at "
                        "most {:.0f}",
                        place, part.drawn_machines, drawn_in_all, most_machines));
      }
      if (part.drawn_machines == 0) chosen.push_back({problem, family.name});
      for (int number = 1; number <= part.drawn_machines; ++number) {
        const auto drawn = catalogue.drawn_problem(problem, number);
        if (drawn) add_searched(chosen, *drawn);
      }
    }
  }
  check_patterns(part.problems, names, place + ", problems", "`ricochet list problems`");
  return chosen;
}

std::vector<Solver> solvers_of(const std::vector<std::string>& texts, const Catalogue& catalogue,
                               std::map<std::string, std::string>& own_texts,
                               const std::string& place) {
  std::vector<std::string> patterns;
  std::vector<Solver> own;
  std::vector<std::string> names;
  for (const Solver& solver : catalogue.solvers) names.push_back(solver.name);
  for (const std::string& text : texts) {
    if (auto solver = catalogue.own_solver ? catalogue.own_solver(text) : std::nullopt) {
      const std::string& known = own_texts.try_emplace(solver->name, text).first->second;
      if (known != text || std::find(names.begin(), names.end(), solver->name) != names.end()) {
        throw InputError(fmt::format("{} {}: there is another solver of its name, {}", place, text,
                                     solver->name));
      }
      names.push_back(solver->name);
      own.push_back(*std::move(solver));
    } else {
      patterns.push_back(text);
    }
  }
  check_patterns(patterns, names, place, "`ricochet list solvers`");
  std::vector<Solver> chosen;
  for (const Solver& solver : catalogue.solvers) {
    const bool named = std::ranges::find(patterns, solver.name) != patterns.end();
    if (named || (!solver.chooses && fits_any(solver.name, patterns))) chosen.push_back(solver);
  }
  chosen.insert(chosen.end(), own.begin(), own.end());
  return chosen;
}

void Campaign::add_part(std::size_t part_index, const Catalogue& catalogue) {
  const PlanPart& part = plan_.parts[part_index];
  const std::string place = fmt::format("part {}", part_index + 1);
  const std::vector<Chosen> chosen = problems_of(part, catalogue, place);
  const std::vector<Solver> solvers =
      solvers_of(part.solvers, catalogue, own_texts_, place + ", solvers");
  const std::vector<PartPerturbation> perturbations = perturbations_of(part, place);
  const auto add = [&](const Problem& problem, const std::string& family,
                       const Formulation& formulation, const PartPerturbation& perturbation,
                       const Solver& solver) {
    for (const std::string& price : part.gradient_prices) {
      for (const std::int64_t budget : part.budgets) {
        Budget spent{budget * problem.dimension()};
        spent.gradient_price = gradient_price_of(price, problem);
        // Runs that are the same at several prices are made and stored once.
        const bool as_n =
            !pays_for_gradients(solver) || spent.gradient_price == problem.dimension();
        if (as_n) spent.gradient_price = std::nullopt;
        const Cell cell{
            problem.name, problem.name_of(formulation),      perturbation.name, solver.name,
            budget,       spent.gradient_price ? price : "n"};
        const auto [known, fresh] = places_.try_emplace(cell, cells_.size());
        if (fresh) {
          cells_.push_back({cell,
                            index_of(problem, family),
                            formulation,
                            perturbation.perturbation,
                            index_of(solver),
                            spent,
                            part.instances,
                            part.seeds,
                            {},
                            {}});
        }
        PlannedCell& planned = cells_[known->second];
        planned.instances = std::max(planned.instances, part.instances);
        planned.seeds = std::max(planned.seeds, part.seeds);
        add_once(planned.parts, part_index);
        add_once(planned.gradient_prices, price);
      }
    }
  };
  struct Combination {
    const Problem* problem;
    const std::string* family;
    Formulation formulation;
    const PartPerturbation* perturbation;
    const Solver* solver;
  };
  std::vector<Combination> combinations;  // counted before their cells take memory
  const double cells_of_combination =
      static_cast<double>(part.gradient_prices.size()) * static_cast<double>(part.budgets.size());
  double cells = 0;
  double shown = 0;  // problems in a formulation and with an optimum somewhere
  for (const auto& [problem, family] : chosen) {
    for (const Formulation& formulation : formulations_of(problem, part)) {
      const Problem formulated = problem.formulated(formulation);
      shown += static_cast<double>(part.relocated_optimum ? perturbations.size() : 1);
      for (const PartPerturbation& perturbation : perturbations) {
        if (!perturbation.applies(formulated)) continue;
        const Problem seen = perturbation.perturbed(formulated);
        for (const Solver& solver : solvers) {
          if (!solver.accepts(seen)) continue;
          combinations.push_back({&problem, &family, formulation, &perturbation, &solver});
          cells += cells_of_combination;
        }
      }
    }
  }
  check_number(cells * part.instances * part.seeds, runs_of_plan, place);
  check_number(shown * part.instances, instances_of_plan, place);
  for (const Combination& each : combinations) {
    add(*each.problem, *each.family, each.formulation, *each.perturbation, *each.solver);
  }
  if (cells == 0) {
    throw InputError(
        fmt::format("{}: none of its solvers takes any of its problems in a formulation "
                    "and with a perturbation that it names",
                    place));
  }
}

const PlannedCell* Campaign::find(const Cell& cell) const {
  const auto place = places_.find(cell);
  return place == places_.end() ? nullptr : &cells_[place->second];
}

bool Campaign::has(const RunKey& key) const {
  const PlannedCell* cell = find(key.cell);
  const int first = plan_.first_instance;
  return cell != nullptr && key.instance >= first && key.instance < first + cell->instances &&
         key.run >= 0 && key.run < cell->seeds;
}

std::int64_t Campaign::runs() const {
  std::int64_t runs = 0;
  for (const PlannedCell& cell : cells_) runs += std::int64_t{cell.instances} * cell.seeds;
  return runs;
}

double Campaign::work() const {
  double work = 0;
  for (const PlannedCell& cell : cells_) {
    work += problems_[cell.problem].cost * static_cast<double>(cell.budget.evaluations) *
            cell.instances * cell.seeds;
  }
  return work;
}

CampaignDescription Campaign::description() const {
  CampaignDescription description;
  description.plan = text_of(plan_);
  for (std::size_t q = 0; q < problems_.size(); ++q) {
    const Problem& problem = problems_[q];
    const auto found = found_.find(problem.name);
    description.problems.push_back(
        {problem.name, families_[q], problem.machine, problem.dimension(), problem.constraints,
         problem.equalities, problem.tolerance, problem.best_known.value(), problem.factors,
         found == found_.end() ? Findings() : found->second, problem_hash(problem)});
  }
  for (const Solver& solver : solvers_) {
    description.solvers.push_back({solver.name, solver.version, solver.content});
  }
  return description;
}

const std::vector<std::string>& names_of_places() {
  static const std::vector<std::string> names = {"optimum-at-lower-end", "optimum-in-middle",
                                                 "optimum-at-upper-end"};
  return names;
}

std::optional<OptimumPlace> place_named(const std::string& perturbation) {
  const auto& names = names_of_places();
  const auto found = std::find(names.begin(), names.end(), perturbation);
  if (found == names.end()) return std::nullopt;
  return static_cast<OptimumPlace>(found - names.begin());
}

bool can_be_relocated(const Problem& problem) {
  if (!problem.best_point) return false;
  const Vector& best = *problem.best_point;
  const Vector margin = 0.01 * (problem.upper - problem.lower);
  return ((best - problem.lower).array() > margin.array()).all() &&
         ((problem.upper - best).array() > margin.array()).all();
}

Problem relocated(Problem problem, OptimumPlace place, int number) {
  const Vector best = problem.best_point.value();
  const Vector half = (best - problem.lower).cwiseMin(problem.upper - best);
  if (place == OptimumPlace::lower_end) problem.lower = best;
  if (place == OptimumPlace::upper_end) problem.upper = best;
  if (place == OptimumPlace::middle) {
    problem.lower = best - half;
    problem.upper = best + half;
  }
  if (problem.smoothed) {
    problem.smoothed = [smoothed = problem.smoothed, place, number](double smoothing) {
      return relocated(smoothed(smoothing), place, number);
    };
  }
  problem.instance = number;
  Random random(seed_of(problem.name, "relocated optimum", number, static_cast<int>(place)));
  problem.start = uniform_point(problem, random);
  problem.start_scales.clear();
  return problem;
}

}  // namespace ricochet
