#include "problems/classic/formula.h"

namespace ricochet::classic {

Problem without_functions(Statement statement) {
  Problem problem;
  problem.name = std::move(statement.name);
  problem.source = std::move(statement.source);
  problem.start = statement.start.cwiseMax(statement.lower).cwiseMin(statement.upper);
  problem.lower = std::move(statement.lower);
  problem.upper = std::move(statement.upper);
  problem.best_known = statement.best_known;
  problem.best_point = std::move(statement.best_point);
  problem.provenance = std::move(statement.provenance);
  if (problem.provenance.starts_with(closed_form)) problem.lower_bound = problem.best_known;
  problem.rotates = statement.rotates;
  problem.start_scales = std::move(statement.start_scales);
  return problem;
}

}  // namespace ricochet::classic
