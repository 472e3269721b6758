#include "src/benchmark/analysis/rating.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "src/benchmark/statistics/empirical_distribution.h"
#include "src/benchmark/statistics/plackett_luce.h"
#include "src/benchmark/statistics/ranking.h"
#include "src/core/seed.h"

namespace ricochet::comparison {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Positions on the axis of evaluations for each variable, from 1 up to the budget.
std::vector<double> places(double budget) {
  std::vector<double> all;
  constexpr int of_a_decade = 6;
  for (int k = 0;; ++k) {
    const double place = std::pow(10.0, k / static_cast<double>(of_a_decade));
    if (place > budget * 1.0001) return all;
    all.push_back(place);
  }
}

/// Evaluations for each variable until each target of the problem was reached, over all runs;
/// infinite if it never was.
std::vector<double> hitting_times(const Problem& problem, const CellResult& result) {
  std::vector<double> times;
  const auto n = static_cast<double>(problem.dimension());
  for (const Outcome& outcome : result.outcomes) {
    for (const double target : targets_of(problem)) {
      const auto reached =
          std::find_if(outcome.steps.begin(), outcome.steps.end(),
                       [&](const Step& step) { return step.optimality_gap <= target; });
      times.push_back(reached == outcome.steps.end()
                          ? infinity
                          : static_cast<double>(reached->evaluations) / n);
    }
  }
  return times;
}

Reached reached_by(const Outcome& outcome) {
  if (outcome.steps.empty()) return {infinity, infinity};
  // Solved runs are equal in value: accuracy beyond the tolerance does not count.
  if (const auto solved = outcome.verdict.evaluations_to_solve) {
    return {0, static_cast<double>(*solved)};
  }
  return {outcome.steps.back().optimality_gap,
          static_cast<double>(outcome.steps.back().evaluations)};
}

/// The results of one entry, by problem.
using ByProblem = std::map<std::size_t, const CellResult*>;

/// Ranks the entries on every instance of every problem and stores the result in `ratings`.
void place(std::vector<Rating>& ratings, const std::vector<const ByProblem*>& entries,
           const std::vector<std::size_t>& problems, std::size_t instances, std::size_t budget) {
  std::vector<Ranking> rankings;
  std::vector<double> sums(ratings.size());
  std::vector<int> taken(ratings.size());
  for (const std::size_t q : problems) {
    for (std::size_t i = 0; i < instances; ++i) {
      std::vector<std::optional<Reached>> reached(ratings.size());
      for (std::size_t c = 0; c < ratings.size(); ++c) {
        const auto mine = entries[c]->find(q);
        if (mine != entries[c]->end()) reached[c] = reached_by(mine->second->outcomes[i]);
      }
      rankings.push_back(ranking_of(reached));
      double before = 0;
      for (const auto& tied : rankings.back()) {
        for (const std::size_t c : tied) {
          sums[c] += before + (static_cast<double>(tied.size()) + 1) / 2;
          ++taken[c];
        }
        before += static_cast<double>(tied.size());
      }
    }
  }
  const auto strengths =
      plackett_luce(rankings, ratings.size(), seed_of("rating", "", static_cast<int>(budget), 0));
  for (std::size_t c = 0; c < ratings.size(); ++c) {
    ratings[c].probability_of_being_best = strengths[c].probability_of_being_best;
    ratings[c].rank = taken[c] > 0 ? sums[c] / taken[c] : infinity;
  }
}

}  // namespace

std::vector<double> targets_of(const Problem& problem) {
  if (problem.tolerance == 0.5) return {0.5, 1.5, 2.5, 4.5, 8.5};  // a count: whole levels
  std::vector<double> targets;
  for (int k = 0; k <= 3; ++k) targets.push_back(problem.tolerance * std::pow(10.0, k));
  return targets;
}

std::vector<Rating> rate(const Comparison& comparison, const std::vector<std::size_t>& problems,
                         std::size_t budget) {
  using Name = std::pair<std::string, std::string>;
  // By entry, then by problem.
  std::map<Name, ByProblem> by_name;
  std::size_t instances = 0;
  for (const CellResult& result : comparison.results) {
    const PlannedCell& planned = *result.cell;
    const Cell& cell = planned.cell;
    if (cell.budget != comparison.part->budgets[budget]) continue;
    if (std::find(problems.begin(), problems.end(), planned.problem) == problems.end()) {
      continue;
    }
    by_name[{cell.solver, cell.formulation}][planned.problem] = &result;
    instances = result.outcomes.size();  // the same for all
  }
  std::vector<Rating> ratings;
  std::vector<const ByProblem*> entries;
  for (const auto& [name, mine] : by_name) {
    Rating rating;
    rating.solver = name.first;
    rating.formulation = name.second;
    rating.problems = static_cast<int>(mine.size());
    std::vector<std::vector<double>> times;
    for (const auto& [q, result] : mine) {
      times.push_back(hitting_times(comparison.problem_of(*result), *result));
      int found = 0;
      int returned = 0;
      for (const Outcome& outcome : result->outcomes) {
        found += outcome.verdict.solved ? 1 : 0;
        returned += outcome.verdict.returned_solved ? 1 : 0;
      }
      rating.never += found == 0 ? 1 : 0;
      const auto all = static_cast<double>(result->outcomes.size() * mine.size());
      rating.found += found / all;
      rating.returned += returned / all;
    }
    for (const double place : places(static_cast<double>(comparison.part->budgets[budget]))) {
      const auto share = empirical_distribution(times, place);
      rating.progress.push_back({place, share.mean, share.interval});
    }
    ratings.push_back(std::move(rating));
    entries.push_back(&mine);
  }
  place(ratings, entries, problems, instances, budget);
  std::stable_sort(ratings.begin(), ratings.end(), [](const Rating& a, const Rating& b) {
    return std::pair(-a.probability_of_being_best, a.rank) <
           std::pair(-b.probability_of_being_best, b.rank);
  });
  return ratings;
}

}  // namespace ricochet::comparison
