#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "src/campaign/campaign.h"
#include "src/core/error.h"
#include "src/core/instance.h"

namespace ricochet {

/// The sum of (x_i - 0.3)^2; with one constraint, x_0 <= 1/2, where wanted.
inline Question bowl(const std::string& name, Eigen::Index n, bool constrained = false) {
  Problem problem;
  problem.name = name;
  problem.source = "sum of (x_i - 0.3)^2";
  problem.lower = Vector::Zero(n);
  problem.upper = Vector::Ones(n);
  problem.start = Vector::Constant(n, 0.9);
  problem.best_known = 0.0;
  problem.best_point = Vector::Constant(n, 0.3);
  problem.constraints = constrained ? 1 : 0;
  problem.evaluate = [constrained](const Vector& x) {
    return Values{(x.array() - 0.3).square().sum(),
                  constrained ? Vector(Vector::Constant(1, x[0] - 0.5)) : Vector()};
  };
  return {.stated = problem, .cost = static_cast<double>(n), .gradient_cost = 3};
}

/// The same, smoothed in name.
inline Question smooth_bowl(const std::string& name, bool constrained) {
  Question question = bowl(name, 2, constrained);
  question.stated.smoothed = [plain = question.stated](double) { return plain; };
  question.width = 0.5;
  return question;
}

/// Accepts what has no constraints.
inline Solver chance(const std::string& name) {
  Solver solver;
  solver.name = name;
  solver.version = "1";
  solver.stochastic = true;
  solver.accepts = [](const Problem& problem) { return problem.constraints == 0; };
  solver.solve = [](Evaluator& evaluator, const Vector& start, Random& random) {
    Vector x = start;
    while (evaluator.objective(x)) x = uniform_point(evaluator.problem(), random);
    return SolverExit{"spent"};
  };
  return solver;
}

inline Catalogue made_up_catalogue() {
  Catalogue catalogue;
  Question open = bowl("bowl-open", 1);
  open.stated.best_known.reset();
  catalogue.families = {
      {"bowl", {bowl("bowl-1", 1), bowl("bowl-2", 2), bowl("bowl-8", 8), open}},
      {"cup",
       {bowl("cup-2", 2, true), smooth_bowl("cup-smooth", true), smooth_bowl("cup-s", false)}}};
  catalogue.solvers = {chance("chance-a"), chance("chance-b"), chance("luck")};
  catalogue.own_solver = [](const std::string& text) -> std::optional<Solver> {
    if (text.find('/') == std::string::npos) return std::nullopt;
    return chance(text.substr(text.rfind('/') + 1));
  };
  catalogue.varied_solver = [](const VariedSolver& varied) {
    if (varied.of != "luck") throw InputError(varied.of + " has no options");
    return chance(varied.name);
  };
  catalogue.families_of = [](const MachineGrid& grid) {
    Family family{"bowl", {}};
    for (const double r : grid.restitution) {
      family.questions.push_back(bowl("bowl-" + grid.around + "-" + std::to_string(r), 1));
    }
    return std::vector{family};
  };
  return catalogue;
}

}  // namespace ricochet
