#include "src/contest/rating.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "src/core/seed.h"
#include "src/statistics/empirical_distribution.h"
#include "src/statistics/plackett_luce.h"
#include "src/statistics/ranking.h"

namespace ricochet::contest {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Places on the axis of evaluations for each variable, from 1 up to the budget.
std::vector<double> places(double budget) {
  std::vector<double> all;
  constexpr int of_a_decade = 6;
  for (int k = 0;; ++k) {
    const double place = std::pow(10.0, k / static_cast<double>(of_a_decade));
    if (place > budget * 1.0001) return all;
    all.push_back(place);
  }
}

/// Evaluations for each variable until every target of the question was reached, over all runs.
std::vector<double> hitting_times(const Question& question, const Standing& standing) {
  std::vector<double> times;
  const auto n = static_cast<double>(question.stated.dimension());
  for (const Outcome& outcome : standing.outcomes) {
    for (const double target : targets_of(question)) {
      const auto reached = std::find_if(outcome.steps.begin(), outcome.steps.end(),
                                        [&](const Step& step) { return step.regret <= target; });
      times.push_back(reached == outcome.steps.end()
                          ? infinity
                          : static_cast<double>(reached->evaluations) / n);
    }
  }
  return times;
}

Reached reached_by(const Outcome& outcome) {
  if (outcome.steps.empty()) return {infinity, infinity};
  // What is solved is solved: digits beyond the tolerance put nobody first.
  if (const auto solved = outcome.verdict.evaluations_to_solve) {
    return {0, static_cast<double>(*solved)};
  }
  return {outcome.steps.back().regret, static_cast<double>(outcome.steps.back().evaluations)};
}

/// The standings of one competitor, by question.
using ByQuestion = std::map<std::size_t, const Standing*>;

/// Ranks the competitors, of which these are the ratings, on every instance of every question.
void place(std::vector<Rating>& ratings, const std::vector<const ByQuestion*>& competitors,
           const ContestPlan& plan, const std::vector<std::size_t>& questions, std::size_t budget) {
  std::vector<Ranking> rankings;
  std::vector<double> sums(ratings.size());
  std::vector<int> taken(ratings.size());
  for (const std::size_t q : questions) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(plan.instances); ++i) {
      std::vector<std::optional<Reached>> reached(ratings.size());
      for (std::size_t c = 0; c < ratings.size(); ++c) {
        const auto mine = competitors[c]->find(q);
        if (mine != competitors[c]->end()) reached[c] = reached_by(mine->second->outcomes[i]);
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

std::vector<double> targets_of(const Question& question) {
  if (question.tolerance == 0.5) return {0.5, 1.5, 2.5, 4.5, 8.5};  // a count: whole levels
  std::vector<double> targets;
  for (int k = 0; k <= 3; ++k) targets.push_back(question.tolerance * std::pow(10.0, k));
  return targets;
}

std::vector<Rating> rate(const ContestPlan& plan, const std::vector<Standing>& standings,
                         const std::vector<std::size_t>& questions, std::size_t budget) {
  using Name = std::pair<std::string, std::string>;
  // By competitor, then by question.
  std::map<Name, ByQuestion> by_name;
  for (const Standing& standing : standings) {
    if (standing.budget != budget) continue;
    if (std::find(questions.begin(), questions.end(), standing.question) == questions.end()) {
      continue;
    }
    const std::string form = plan.questions[standing.question].name_of(standing.form);
    by_name[{standing.solver, form}][standing.question] = &standing;
  }
  std::vector<Rating> ratings;
  std::vector<const ByQuestion*> competitors;
  for (const auto& [name, mine] : by_name) {
    Rating rating;
    rating.solver = name.first;
    rating.form = name.second;
    rating.questions = static_cast<int>(mine.size());
    std::vector<std::vector<double>> times;
    for (const auto& [q, standing] : mine) {
      times.push_back(hitting_times(plan.questions[q], *standing));
      int found = 0;
      int handed_over = 0;
      for (const Outcome& outcome : standing->outcomes) {
        found += outcome.verdict.solved ? 1 : 0;
        handed_over += outcome.verdict.handed_over_solved ? 1 : 0;
      }
      rating.never += found == 0 ? 1 : 0;
      const auto all = static_cast<double>(standing->outcomes.size() * mine.size());
      rating.found += found / all;
      rating.handed_over += handed_over / all;
    }
    for (const double place : places(static_cast<double>(plan.budgets[budget]))) {
      const auto share = empirical_distribution(times, place);
      rating.progress.push_back({place, share.mean, share.interval});
    }
    ratings.push_back(std::move(rating));
    competitors.push_back(&mine);
  }
  place(ratings, competitors, plan, questions, budget);
  std::stable_sort(ratings.begin(), ratings.end(), [](const Rating& a, const Rating& b) {
    return std::pair(-a.probability_of_being_best, a.rank) <
           std::pair(-b.probability_of_being_best, b.rank);
  });
  return ratings;
}

}  // namespace ricochet::contest
