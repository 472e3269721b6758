#include "solvers/automatic.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

namespace ricochet {

namespace {

/// A gradient costs less than this share of as many values as there are variables.
constexpr double cheap = 0.75;

bool takes(const Solver& solver, const Evaluator& of) {
  const Capabilities& can = solver.capabilities;
  const Capabilities::Constraints needed = of.constraints() == 0 ? Capabilities::Constraints::none
                                           : of.equalities() == 0
                                               ? Capabilities::Constraints::inequalities
                                               : Capabilities::Constraints::all;
  return of.dimension() >= can.least_variables && of.dimension() <= can.most_variables &&
         can.constraints >= needed;
}

bool has_only_bounds(const Evaluator& of) {
  return of.constraints() == 0;
}

}  // namespace

const std::vector<RuleLine>& rule_of_auto() {
  static const std::vector<RuleLine> lines = {
      {"one variable",
       "one variable",
       "a mesh finds the best of several valleys, whether values jump or not",
       {"mads-tuned"},
       [](const Evaluator& of) { return of.dimension() == 1; }},
      {"jumps, with a cheap surrogate",
       "values that jump, and a smooth surrogate whose gradient costs little",
       "the surrogate's gradient leads across plateaus that hide the way from values",
       {"continuation-nlopt-slsqp"},
       [](const Evaluator& of) {
         return of.jumps() && has_only_bounds(of) && of.has_smoothing() &&
                static_cast<double>(of.gradient_price()) <
                    cheap * static_cast<double>(of.dimension());
       }},
      {"jumps, with constraints",
       "values that jump, and constraints",
       "a mesh and a barrier need no model of what jumps",
       {"mads-tuned"},
       [](const Evaluator& of) { return of.jumps() && !has_only_bounds(of); }},
      {"jumps",
       "values that jump",
       "a population compares values, and does not model them",
       {"pagmo-cmaes-ipop", "mads-tuned"},
       [](const Evaluator& of) { return of.jumps(); }},
      {"residuals",
       "residuals, no constraints",
       "a model of each residual learns more from a value than one of their sum",
       {"tao-pounders", "ceres-trust-region"},
       [](const Evaluator& of) { return of.has_residuals() && has_only_bounds(of); }},
      {"derivatives",
       "derivatives",
       "sequential quadratic programming takes all constraints, and the fewest evaluations",
       {"scipy-slsqp", "nlopt-slsqp", "ipopt"},
       [](const Evaluator& of) { return of.has_derivatives(); }},
      {"constraints",
       "constraints, no derivatives",
       "linear models of objective and constraints",
       {"nlopt-cobyla"},
       [](const Evaluator& of) { return !has_only_bounds(of); }},
      {"values alone",
       "values alone",
       "quadratic models, from one start after the other",
       {"nlopt-mlsl-bobyqa"},
       [](const Evaluator&) { return true; }}};
  return lines;
}

std::optional<Choice> choice_of(const Evaluator& evaluator, const std::vector<Solver>& solvers) {
  for (const RuleLine& line : rule_of_auto()) {
    if (!line.applies(evaluator)) continue;
    for (const std::string& name : line.solvers) {
      const auto found = std::find_if(solvers.begin(), solvers.end(), [&](const Solver& solver) {
        return solver.name == name && takes(solver, evaluator);
      });
      if (found != solvers.end()) return Choice{&line, name};
    }
  }
  return std::nullopt;
}

Solver automatic(std::vector<Solver> solvers) {
  Solver solver;
  solver.name = "auto";
  solver.version = "ricochet " RICOCHET_VERSION;
  solver.stochastic = true;
  solver.chooses = true;
  solver.capabilities.constraints = Capabilities::Constraints::all;
  solver.at_limit = AtLimit::own_point;
  solver.solve = [all = std::make_shared<const std::vector<Solver>>(std::move(solvers))](
                     Evaluator& evaluator, const Vector& start, Random& random) {
    const std::optional<Choice> choice = choice_of(evaluator, *all);
    if (!choice) throw std::runtime_error("this build has no solver that auto would choose");
    const auto chosen = std::find_if(
        all->begin(), all->end(), [&](const Solver& each) { return each.name == choice->solver; });
    SolverTermination exit = chosen->solve(evaluator, start, random);
    exit.reason = fmt::format("{} ({}): {}", choice->solver, choice->line->name, exit.reason);
    return exit;
  };
  return solver;
}

}  // namespace ricochet
