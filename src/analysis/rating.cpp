#include "src/analysis/rating.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

#include "ricochet/random.h"
#include "src/analysis/outcomes.h"
#include "src/analysis/statistics/profiles.h"
#include "src/analysis/statistics/ranking.h"
#include "src/core/instance.h"

namespace ricochet::comparison {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Evaluations for each variable until each target of the problem was reached, over all runs;
/// infinite if it never was.
std::vector<double> hitting_times(const Problem& problem, const CellResult& result) {
  std::vector<double> times;
  const auto n = static_cast<double>(problem.dimension());
  for (const Outcome& outcome : result.outcomes) {
    const std::vector<Step> steps = steps_of(outcome);
    for (const double target : *result.targets) {
      const auto reached = std::find_if(steps.begin(), steps.end(),
                                        [&](const Step& s) { return s.optimality_gap <= target; });
      times.push_back(reached == steps.end() ? never
                                             : static_cast<double>(reached->evaluations) / n);
    }
  }
  return times;
}

/// The results of one entry, by problem.
using ByProblem = std::map<std::size_t, const CellResult*>;
using Name = std::pair<std::string, std::string>;  ///< solver and formulation

std::map<Name, ByProblem> by_entry(const Comparison& comparison,
                                   const std::vector<std::size_t>& problems, std::size_t budget) {
  std::map<Name, ByProblem> entries;
  for (const CellResult& result : comparison.results) {
    const Cell& cell = result.cell->cell;
    const std::size_t q = result.cell->problem;
    if (cell.budget != comparison.part->budgets[budget]) continue;
    if (std::find(problems.begin(), problems.end(), q) == problems.end()) continue;
    entries[{cell.solver, cell.formulation}][q] = &result;
  }
  return entries;
}

/// The entries' rankings on every instance of one problem.
RivalsAhead on_problem(const std::vector<const ByProblem*>& entries, std::size_t problem) {
  std::vector<const Outcomes*> outcomes;
  std::size_t instances = 0;
  for (const ByProblem* mine : entries) {
    const auto found = mine->find(problem);
    outcomes.push_back(found == mine->end() ? nullptr : &found->second->outcomes);
    if (outcomes.back() != nullptr) instances = outcomes.back()->size();  // the same for all
  }
  std::vector<Ranking> rankings;
  for (std::size_t i = 0; i < instances; ++i) {
    std::vector<std::optional<Reached>> reached(entries.size());
    for (std::size_t e = 0; e < entries.size(); ++e) {
      if (outcomes[e] != nullptr) reached[e] = reached_by((*outcomes[e])[i]);
    }
    rankings.push_back(ranking_of(reached));
  }
  return rivals_ahead(rankings);
}

bool is_ranked(const ByProblem& entry, const std::vector<std::size_t>& problems) {
  return 2 * entry.size() >= problems.size();
}

RankedEntries ranked(const Comparison& comparison, const std::map<Name, ByProblem>& entries,
                     const std::vector<std::size_t>& problems) {
  RankedEntries all;
  std::vector<const ByProblem*> results;
  for (const auto& [name, mine] : entries) {
    if (!is_ranked(mine, problems)) continue;
    all.names.push_back(entry(name.first, name.second));
    results.push_back(&mine);
  }
  for (const std::size_t q : problems) {
    RivalsAhead of_problem = on_problem(results, q);
    of_problem.cluster = cluster_of(comparison.campaign->problems()[q]);
    if (!of_problem.entries.empty()) all.problems.push_back(std::move(of_problem));
  }
  return all;
}

/// Everything but the ranks.
Rating rating_of(const Name& name, const ByProblem& mine, const Comparison& comparison,
                 std::size_t budget) {
  Rating rating;
  rating.solver = name.first;
  rating.formulation = name.second;
  rating.problems = static_cast<int>(mine.size());
  std::vector<std::vector<double>> times;
  std::vector<std::string> clusters;
  for (const auto& [q, result] : mine) {
    clusters.push_back(cluster_of(comparison.problem_of(*result)));
    rating.surrogate = result->cell->formulation.smoothing > 0;
    times.push_back(hitting_times(comparison.problem_of(*result), *result));
    int found = 0;
    int returned = 0;
    for (const Outcome& outcome : result->outcomes) {
      found += outcome.solved(Criterion::evaluated) ? 1 : 0;
      returned += outcome.solved(Criterion::returned) ? 1 : 0;
    }
    rating.never += returned == 0 ? 1 : 0;
    const auto all = static_cast<double>(result->outcomes.size() * mine.size());
    rating.found += found / all;
    rating.returned += returned / all;
  }
  for (const double place :
       evaluation_places(static_cast<double>(comparison.part->budgets[budget]))) {
    const auto share = empirical_distribution(times, place, clusters);
    rating.progress.push_back({place, share.mean, share.interval});
  }
  return rating;
}

/// Sets ranks and probabilities of the ratings that are ranked, which are in the order of `places`.
void set_ranks(std::vector<Rating*>& ratings, const RankedEntries& places, std::size_t budget) {
  const std::size_t size = ratings.size();
  const auto means = mean_rivals_ahead(places.problems, size);
  for (std::size_t e = 0; e < size; ++e) {
    ratings[e]->rank = 1 + means[e].value_or(0) * (static_cast<double>(size) - 1);
  }
  const bool solved =
      std::any_of(ratings.begin(), ratings.end(), [](const Rating* r) { return r->returned > 0; });
  if (!solved || clusters_of(places.problems).size() < 2) return;
  const auto probabilities = probabilities_of_being_first(
      places.problems, size, seed_of("rating", "", static_cast<int>(budget), 0));
  for (std::size_t e = 0; e < size; ++e) {
    ratings[e]->probability_of_being_best = probabilities[e];
  }
}

}  // namespace

std::vector<double> evaluation_places(double budget) {
  std::vector<double> all;
  constexpr int of_a_decade = 6;
  for (int k = 0;; ++k) {
    const double place = std::pow(10.0, k / static_cast<double>(of_a_decade));
    if (place > budget * 0.9999) break;
    all.push_back(place);
  }
  all.push_back(budget);
  return all;
}

RankedEntries ranked_entries(const Comparison& comparison, const std::vector<std::size_t>& problems,
                             std::size_t budget) {
  return ranked(comparison, by_entry(comparison, problems, budget), problems);
}

std::vector<Rating> rate(const Comparison& comparison, const std::vector<std::size_t>& problems,
                         std::size_t budget) {
  const std::map<Name, ByProblem> entries = by_entry(comparison, problems, budget);
  std::vector<Rating> ratings;
  for (const auto& [name, mine] : entries) {
    ratings.push_back(rating_of(name, mine, comparison, budget));
  }
  std::vector<Rating*> compared;
  std::size_t k = 0;
  for (const auto& [name, mine] : entries) {
    if (is_ranked(mine, problems)) compared.push_back(&ratings[k]);
    ++k;
  }
  set_ranks(compared, ranked(comparison, entries, problems), budget);
  const auto key = [](const Rating& r) {
    return std::tuple(r.rank.value_or(never), -r.problems, -r.returned);
  };
  std::stable_sort(ratings.begin(), ratings.end(),
                   [&](const Rating& a, const Rating& b) { return key(a) < key(b); });
  return ratings;
}

const Rating* leader_of(const std::vector<Rating>& ratings) {
  if (ratings.empty() || !ratings.front().rank) return nullptr;
  return ratings.front().returned > 0 ? &ratings.front() : nullptr;
}

std::vector<std::size_t> stratified_sample(const std::vector<double>& values, std::size_t number,
                                           std::uint64_t seed) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return values[i]; });
  if (number >= order.size()) return order;
  Random random(seed);
  std::vector<std::size_t> drawn;
  for (std::size_t stratum = 0; stratum < number; ++stratum) {
    const std::size_t from = stratum * order.size() / number;
    const std::size_t to = (stratum + 1) * order.size() / number;
    const double place = uniform(random) * static_cast<double>(to - from);
    drawn.push_back(order[from + static_cast<std::size_t>(place)]);
  }
  return drawn;
}

}  // namespace ricochet::comparison
