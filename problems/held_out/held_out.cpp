#include "problems/held_out/held_out.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "problems/classic/classic.h"

namespace ricochet::held_out {

namespace {

/// What counts as solved, relative to the best value, or to 1: where values have kinks, or jump, a
/// hundred times as much.
constexpr double tolerance_of_rough = 1e-4;

/// With the tolerance and cost that problems of the literature have, and a weight of penalties
/// that keeps the best point best.
void complete(Problem& problem) {
  problem.held_out = true;
  if (!problem.differentiate) {
    problem.tolerance = tolerance_of_rough * std::max(1.0, std::abs(problem.best_known.value()));
    problem.gradient_cost = problem.dimension();
    return;
  }
  problem = classic::with_tolerance(std::move(problem));
  if (problem.constraints == 0) return;
  const auto multipliers = classic::multipliers_at_best(problem);
  if (!multipliers) return;
  const double steepest = multipliers->lpNorm<Eigen::Infinity>();
  problem.penalty_weight = std::max(problem.penalty_weight, 2 * steepest);
}

Family family_of(const char* name, std::vector<Problem> problems) {
  for (Problem& problem : problems) complete(problem);
  return {name, std::move(problems)};
}

}  // namespace

classic::Statement stated(const char* family, const char* name, const char* source, Vector lower,
                          Vector upper, Vector start, double best_known, Vector best_point,
                          const char* provenance) {
  classic::Statement statement;
  statement.name = std::string(family) + "-" + name;
  statement.source = source;
  statement.start = start.size() == 0 ? Vector((lower + upper) / 2) : std::move(start);
  statement.lower = std::move(lower);
  statement.upper = std::move(upper);
  statement.best_known = best_known;
  statement.best_point = std::move(best_point);
  statement.provenance = provenance;
  return statement;
}

std::vector<Family> families() {
  return {family_of("outside-global", global_problems()),
          family_of("outside-smooth", smooth_problems()),
          family_of("outside-constrained", constrained_problems()),
          family_of("outside-fit", fit_problems()), family_of("outside-rough", rough_problems())};
}

}  // namespace ricochet::held_out
