#include "src/report/site/chooser.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "src/analysis/statistics/intervals.h"
#include "src/report/site/entries.h"

namespace ricochet::site {

namespace {

constexpr std::size_t shown = 3;  ///< entries of each kind

/// The perturbations that are a reader's trouble, and not a test of a solver's invariance.
const std::vector<Trouble> known_troubles = {
    {"noisy", "noise, new at every call"},
    {"frozen-noise", "noise, the same at a point"},
    {"outliers", "outliers"},
    {"nan", "missing values (NaN)"},
    {"throwing", "evaluations that fail"},
    {"truncated", "values of six digits"},
    {"quantised", "variables on a grid"},
    {"infinite-where-infeasible", "infinite where infeasible"},
    {"binary-constraints", "constraints that only say yes or no"}};

/// What a comparison knows of its solvers and families.
class Known {
 public:
  explicit Known(const FoundReport& report) {
    const auto data = report.data.get<ComparisonData>();
    for (const NamedSolver& solver : data.solvers) {
      if (solver.needs && *solver.needs != "nothing") derivative_.insert(solver.name);
    }
    for (const SpeedAccuracy& one : data.speed_accuracy) {
      if (one.budget) fast_[{one.family, *one.budget, one.solver, one.formulation}] = one;
    }
    for (const LeadingEntry& leader : data.leaders) {
      if (leader.easy.value_or(false)) easy_[{leader.family, leader.budget}] = leader.random;
    }
  }

  bool needs_derivatives(const std::string& solver) const { return derivative_.contains(solver); }

  /// Evaluations that random search needs, if the family is too easy to name a first entry.
  std::optional<double> random(const std::string& family, double budget) const {
    const auto found = easy_.find({family, budget});
    return found == easy_.end() ? std::nullopt : found->second;
  }

  const SpeedAccuracy* speed_accuracy(const std::string& family, double budget,
                                      const Rating& rating) const {
    const auto found = fast_.find({family, budget, rating.solver, rating.formulation});
    return found == fast_.end() ? nullptr : &found->second;
  }

 private:
  std::set<std::string> derivative_;
  std::map<std::tuple<std::string, double, std::string, std::string>, SpeedAccuracy> fast_;
  std::map<std::pair<std::string, double>, std::optional<double>> easy_;
};

/// Keeps the first entries, and the first without derivatives.
std::vector<Choice> first_of(const std::vector<Choice>& all) {
  std::vector<Choice> kept;
  std::size_t any = 0, plain = 0;
  for (const Choice& choice : all) {
    const bool wanted = any < shown || (!choice.gradient && plain < shown);
    ++any;
    if (!choice.gradient) ++plain;
    if (wanted) kept.push_back(choice);
  }
  return kept;
}

bool is_count(const std::string& formulation) {
  return formulation.find("count") != std::string::npos ||
         formulation.find("surrogate") != std::string::npos;
}

Situation situation_of(const Known& known, const FamilyData& family, const RatedBudget& budget,
                       const std::string& folder) {
  const FamilySize size = size_of(family.family, family.problems);
  Situation situation{.family = family.family,
                      .title = {},
                      .folder = folder,
                      .counts = false,
                      .problems = static_cast<std::int64_t>(size.problems),
                      .variables = size.variables,
                      .constraints = size.constraints,
                      .budget = budget.budget,
                      .perturbation = "plain",
                      .runs = {},
                      .random = known.random(family.family, budget.budget),
                      .entries = {}};
  std::vector<Choice> all;
  for (const Rating& rating : budget.ratings) {
    situation.counts = situation.counts || is_count(rating.formulation);
    if (!rating.rank || rating.returned <= 0) continue;
    const SpeedAccuracy* fast = known.speed_accuracy(family.family, budget.budget, rating);
    Choice choice{rating.solver,
                  rating.formulation,
                  known.needs_derivatives(rating.solver),
                  rating.returned,
                  {},
                  {},
                  rating.best,
                  rating.problems};
    if (fast != nullptr) {
      choice.lower = fast->share_lower;
      choice.upper = fast->share_upper;
    }
    all.push_back(std::move(choice));
  }
  situation.entries = first_of(all);
  return situation;
}

/// The entries of a family under one perturbation, best first.
std::vector<Choice> choices_under(const Known& known, const std::vector<PerturbedEntry>& entries,
                                  std::size_t perturbation) {
  std::vector<Choice> all;
  for (const PerturbedEntry& entry : entries) {
    const Json& cell = entry.shares.at(perturbation);
    const double share = cell.is_null() ? 0 : cell.get<double>();
    if (share <= 0) continue;
    const double runs = static_cast<double>(entry.runs);
    const Interval interval = wilson_interval(share * runs, runs);
    all.push_back({entry.solver, entry.formulation, known.needs_derivatives(entry.solver), share,
                   interval.lower, interval.upper, std::nullopt, entry.problems});
  }
  std::ranges::stable_sort(all,
                           [](const Choice& a, const Choice& b) { return a.solved > b.solved; });
  return all;
}

void add_perturbed(const Known& known, const PerturbedData& data, const std::string& folder,
                   Chooser& chooser) {
  std::map<std::string, std::vector<PerturbedEntry>> families;
  for (const PerturbedEntry& entry : data.perturbation_rows) {
    families[entry.family].push_back(entry);
  }
  for (std::size_t p = 0; p < data.perturbation_names.size(); ++p) {
    const std::string& name = data.perturbation_names[p].perturbation;
    const bool offered = std::ranges::any_of(
        known_troubles, [&](const Trouble& trouble) { return trouble.perturbation == name; });
    if (!offered) continue;
    for (const auto& [family, entries] : families) {
      const auto plain = std::ranges::find_if(
          chooser.situations,
          [&, &its = family](const Situation& one) { return one.family == its; });
      std::vector<Choice> choices = first_of(choices_under(known, entries, p));
      if (choices.empty() || plain == chooser.situations.end()) continue;
      Situation situation = *plain;
      situation.folder = folder;
      situation.problems = entries.front().problems;
      situation.variables = {entries.front().least_variables, entries.front().most_variables};
      situation.budget = entries.front().budget;
      situation.perturbation = name;
      situation.runs = entries.front().runs;
      situation.random.reset();
      situation.entries = std::move(choices);
      chooser.situations.push_back(std::move(situation));
    }
  }
}

std::string title_of(const std::string& family, const FamilyTitles& titles) {
  std::string longest;
  for (const auto& [name, title] : titles) {
    if (family.starts_with(name) && name.size() > longest.size()) longest = name;
  }
  return longest.empty() ? "" : titles.at(longest);
}

struct TitledFamily {
  std::string name, title;
};
RICOCHET_FIELDS(TitledFamily, name, title);

}  // namespace

FamilyTitles family_titles(const std::vector<FoundReport>& reports) {
  FamilyTitles titles;
  for (const FoundReport& report : reports) {
    if (report.kind.name != "problems" || !report.data.contains("families")) continue;
    for (const Json& one : report.data["families"]) {
      const auto family = one.get<TitledFamily>();
      titles[family.name] = family.title;
    }
    break;
  }
  return titles;
}

Chooser chooser_of(const FoundReport& comparison, const FamilyTitles& titles) {
  const Known known(comparison);
  Chooser chooser{comparison.folder, {}, {}};
  for (const FoundPage& page : comparison.pages) {
    if (!holds(page.headline, "family")) continue;
    const auto family = page.data.get<FamilyData>();
    for (const RatedBudget& budget : family.budgets) {
      Situation situation =
          situation_of(known, family, budget, comparison.folder + "/" + page.folder);
      situation.title = title_of(family.family, titles);
      if (!situation.entries.empty()) chooser.situations.push_back(std::move(situation));
    }
  }
  for (const FoundPage& page : comparison.pages) {
    if (!holds(page.headline, "perturbations")) continue;
    add_perturbed(known, page.data.get<PerturbedData>(), comparison.folder + "/" + page.folder,
                  chooser);
  }
  for (const Trouble& trouble : known_troubles) {
    const bool there = std::ranges::any_of(chooser.situations, [&](const Situation& one) {
      return one.perturbation == trouble.perturbation;
    });
    if (there) chooser.troubles.push_back(trouble);
  }
  return chooser;
}

namespace {

struct Simulated {
  std::string family;                     ///< of problems whose answer the simulations compute
  std::vector<std::string> formulations;  ///< in which every evaluation is one simulation
  double tolerance;
  std::vector<std::string> names;  ///< of the cases
  std::vector<PairedSimulation> simulations;
};
RICOCHET_FIELDS(Simulated, family, formulations, tolerance, names, simulations);

/// Returns the seconds of a simulation from the family's page for this budget; nothing if it is
/// missing.
std::optional<double> simulation_seconds(const FoundReport& report, const std::string& family,
                                         double budget) {
  for (const FoundPage& page : report.pages) {
    if (!holds(page.headline, "family")) continue;
    const auto data = page.data.get<FamilyData>();
    if (data.family != family) continue;
    for (const BreakEven& one : data.break_even_families) {
      if (one.budget == budget && !one.here.empty()) return one.here.front().simulation;
    }
  }
  return std::nullopt;
}

std::vector<PairedSolver> solvers_of(const FoundReport& report, const Simulated& simulated) {
  std::vector<PairedSolver> solvers;
  for (const SpeedAccuracy& one : report.data.get<ComparisonData>().speed_accuracy) {
    const bool fits = one.family == simulated.family && one.largest && one.budget &&
                      std::ranges::count(simulated.formulations, one.formulation) > 0;
    if (!fits || one.share.value_or(0) <= 0) continue;
    if (!one.seconds || !one.evaluations || !one.share_lower || !one.share_upper) continue;
    const auto simulation = simulation_seconds(report, one.family, *one.budget);
    if (!simulation) continue;
    const double own = *one.seconds - *one.evaluations * *simulation;
    solvers.push_back({one.solver, one.formulation, *one.evaluations, std::max(own, 0.0),
                       *one.share, *one.share_lower, *one.share_upper});
  }
  return solvers;
}

/// The fastest answer of the cases [rad/s].
double fastest_of(const Json& cases) {
  double fastest = 0;
  for (const Json& one : cases) {
    const Json& threshold = one.at("threshold");
    if (threshold.is_number()) fastest = std::max(fastest, threshold.get<double>());
  }
  return fastest;
}

std::string time_text(double seconds) {
  return seconds < 0.1 ? fmt::format("{:.2g} ms", 1e3 * seconds) : fmt::format("{:.2g} s", seconds);
}

}  // namespace

std::optional<Pairs> pairs_of(const FoundReport& simulating, const FoundReport& comparing) {
  auto simulated = simulating.data.at("thresholds").get<Simulated>();
  std::erase_if(simulated.simulations, [](const PairedSimulation& one) { return !one.error; });
  std::vector<PairedSolver> solvers = solvers_of(comparing, simulated);
  if (solvers.empty() || simulated.simulations.empty()) return std::nullopt;
  return Pairs{simulating.folder,   comparing.folder,
               simulated.family,    std::move(simulated.names),
               simulated.tolerance, fastest_of(simulating.data.at("thresholds").at("cases")),
               std::move(solvers),  std::move(simulated.simulations)};
}

std::vector<Pair> all_pairs(const Pairs& pairs) {
  std::vector<Pair> all;
  for (std::size_t s = 0; s < pairs.solvers.size(); ++s) {
    const PairedSolver& solver = pairs.solvers[s];
    for (std::size_t m = 0; m < pairs.simulations.size(); ++m) {
      const PairedSimulation& simulation = pairs.simulations[m];
      const double spent = solver.own + solver.evaluations * simulation.seconds;
      all.push_back({s, m, spent / solver.solved,
                     std::min(*simulation.error + pairs.tolerance, pairs.range)});
    }
  }
  return all;
}

std::vector<Pair> leading(std::vector<Pair> pairs) {
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return a.seconds != b.seconds ? a.seconds < b.seconds : a.error < b.error;
  });
  std::vector<Pair> front;
  for (const Pair& pair : pairs) {
    if (front.empty() || pair.error < front.back().error) front.push_back(pair);
  }
  return front;
}

std::vector<Pair> within_range(const Pairs& pairs) {
  const std::vector<Pair> all = all_pairs(pairs);
  std::vector<Pair> within = all;
  std::erase_if(within, [&](const Pair& pair) { return pair.error >= pairs.range; });
  return within.empty() ? all : within;
}

std::string name_of(const Pairs& pairs, const Pair& pair) {
  const PairedSimulation& simulation = pairs.simulations[pair.simulation];
  return fmt::format("{}, {}{}{}", pairs.solvers[pair.solver].solver, simulation.simulation,
                     simulation.control.empty() ? "" : " ", simulation.control);
}

std::string title_of(const Pairs& pairs) {
  const Pair best = leading(within_range(pairs)).back();
  return fmt::format("The most accurate pair is {}: {:.2g} rad/s in {}", name_of(pairs, best),
                     best.error, time_text(best.seconds));
}

std::string finding_of(const Pairs& pairs) {
  const std::vector<Pair> all = all_pairs(pairs), front = leading(within_range(pairs));
  const auto told = [&](const Pair& pair) {
    return fmt::format("{} (within {:.2g} rad/s after {})", name_of(pairs, pair), pair.error,
                       time_text(pair.seconds));
  };
  const std::string best = told(front.back());
  if (front.size() == 1) {
    return fmt::format("Of {} pairs {} is the fastest and the most accurate.", all.size(), best);
  }
  return fmt::format("Of {} pairs the most accurate is {}; the fastest is {}.", all.size(), best,
                     told(front.front()));
}

}  // namespace ricochet::site
