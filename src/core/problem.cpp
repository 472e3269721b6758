#include "ricochet/problem.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "ricochet/error.h"
#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "src/core/evaluator.h"
#include "src/core/names.h"

namespace ricochet {

double violation_of(double constraint, bool is_equality) {
  const double excess = is_equality ? std::abs(constraint) : constraint;
  return excess <= constraint_tolerance ? 0 : excess;
}

TrueValues true_values_at(const Problem& problem, const Vector& x) {
  return problem.true_values ? problem.true_values(x)
                             : true_values_of(problem.evaluate(x), problem.equalities);
}

TrueValues true_values_of(const Values& values, Eigen::Index equalities) {
  double violation = 0;
  for (Eigen::Index i = 0; i < values.constraints.size(); ++i) {
    const double broken_by = violation_of(values.constraints[i], i < equalities);
    // NaN stays NaN, so that the point is not feasible.
    if (broken_by > violation || std::isnan(broken_by)) violation = broken_by;
  }
  return {values.objective, violation};
}

bool better(const TrueValues& a, const TrueValues& b) {
  if (a.violation != b.violation) return a.violation < b.violation;
  return a.objective < b.objective;
}

std::vector<Formulation> Problem::formulations(const std::vector<double>& smoothings) const {
  std::vector<double> all = {0};
  const auto add = [&](double s) {
    if (std::find(all.begin(), all.end(), s) == all.end()) all.push_back(s);
  };
  if (smoothed) {
    add(smoothing);
    for (const double s : smoothings) add(s);
  }
  std::vector<Formulation> formulations;
  for (const double s : all) {
    formulations.push_back({s});
    if (constraints > 0) formulations.push_back({s, true});
  }
  return formulations;
}

Problem Problem::formulated(const Formulation& formulation) const {
  if ((formulation.smoothing > 0 && !smoothed) || (formulation.penalised && constraints == 0)) {
    throw std::invalid_argument(fmt::format("{} has no formulation with smoothing {}{}", name,
                                            formulation.smoothing,
                                            formulation.penalised ? ", penalised" : ""));
  }
  Problem result = formulation.smoothing > 0 ? smoothed(formulation.smoothing) : *this;
  result.gradient_cost = gradient_cost;
  result.factors = factors;
  return formulation.penalised ? ricochet::penalised(result, penalty_weight) : result;
}

std::string Problem::name_of(const Formulation& formulation) const {
  if (!smoothed) return formulation.penalised ? "penalised" : "original";
  const std::string shown = formulation.smoothing == 0 ? "count"
                            : formulation.smoothing == smoothing
                                ? "surrogate"
                                : fmt::format("surrogate-{}", formulation.smoothing);
  return formulation.penalised ? "penalised-" + shown : shown;
}

Formulation Problem::formulation_named(const std::string& wanted) const {
  if (wanted.empty()) return {};
  std::vector<std::string> known;
  for (const Formulation& formulation : formulations()) {
    known.push_back(name_of(formulation));
    if (known.back() == wanted) return formulation;
  }
  throw InputError(
      fmt::format("{}: {} has no such formulation; {}", wanted, name, what_instead(wanted, known)));
}

namespace {

bool has_room(const Problem& problem) {
  return (problem.upper.array() > problem.lower.array()).any();
}

bool accepts_constraints(const Capabilities& capabilities, const Problem& problem) {
  if (problem.constraints == 0) return !capabilities.needs_constraints;
  switch (capabilities.constraints) {
    case Capabilities::Constraints::none:
      return false;
    case Capabilities::Constraints::inequalities:
      return problem.equalities == 0;
    case Capabilities::Constraints::all:
      return true;
  }
  return false;
}

}  // namespace

bool Capabilities::accept(const Problem& problem) const {
  const Eigen::Index n = problem.dimension();
  return n >= least_variables && n <= most_variables && has_room(problem) &&
         accepts_constraints(*this, problem) &&
         (derivatives < Order::gradient || problem.differentiate) &&
         (derivatives < Order::hessian || problem.lagrangian_hessian) &&
         (!needs_residuals || problem.residuals) && (!needs_smoothing || problem.smoothed);
}

std::string Capabilities::variables_in_words() const {
  if (least_variables == most_variables) return fmt::format("{}", least_variables);
  if (most_variables == any_number) {
    return least_variables == 1 ? "any number" : fmt::format("{} or more", least_variables);
  }
  return least_variables == 1 ? fmt::format("up to {}", most_variables)
                              : fmt::format("{} to {}", least_variables, most_variables);
}

std::string Capabilities::constraints_in_words() const {
  switch (constraints) {
    case Constraints::none:
      return "none";
    case Constraints::inequalities:
      return needs_constraints ? "needs inequalities" : "inequalities";
    case Constraints::all:
      return needs_constraints ? "needs some" : "all";
  }
  return "";
}

std::string Capabilities::needs_in_words() const {
  std::vector<const char*> needs;
  if (derivatives == Order::gradient) needs.push_back("gradients");
  if (derivatives == Order::hessian) needs.push_back("Hessians");
  if (needs_residuals) needs.push_back("residuals");
  if (needs_smoothing) needs.push_back("smoothing");
  return needs.empty() ? "nothing" : fmt::format("{}", fmt::join(needs, ", "));
}

Verdict judge(const RunRecord& record, const std::optional<double>& best_known, double tolerance) {
  Verdict verdict;
  for (const Improvement& step : record.trace) {
    if (step.true_values.violation > 0) continue;
    verdict.feasible = true;
    verdict.objective = step.true_values.objective;
    if (!best_known) continue;
    verdict.optimality_gap = step.true_values.objective - *best_known;
    if (*verdict.optimality_gap <= tolerance && !verdict.solved) {
      verdict.solved = true;
      verdict.evaluations_to_solve = step.evaluations;
      verdict.seconds_to_solve = step.seconds;
    }
  }
  const auto& returned = record.returned;
  if (returned && returned->true_values.violation <= 0 && best_known) {
    verdict.returned_optimality_gap = returned->true_values.objective - *best_known;
    verdict.returned_solved = *verdict.returned_optimality_gap <= tolerance;
  }
  return verdict;
}

Verdict judge(const RunRecord& record, const Problem& problem, double tolerance) {
  return judge(record, problem.best_known, tolerance);
}

}  // namespace ricochet
