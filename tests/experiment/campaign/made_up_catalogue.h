#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/error.h"
#include "src/core/instance.h"
#include "src/experiment/campaign.h"

namespace ricochet {

/// The levels of the restitution that a plan names.
inline std::vector<double> restitutions(const MachineGrid& grid) {
  std::vector<double> numbers;
  const auto levels = grid.levels.find("restitution");
  if (levels == grid.levels.end()) return numbers;
  for (const OptionValue& level : levels->second) numbers.push_back(std::get<double>(level));
  return numbers;
}

/// The sum of (x_i - 0.3)^2; with one constraint, x_0 <= 1/2, where wanted.
inline Problem bowl(const std::string& name, Eigen::Index n, bool constrained = false) {
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
  problem.cost = static_cast<double>(n);
  problem.gradient_cost = 3;
  return problem;
}

/// The same, smoothed in name.
inline Problem smooth_bowl(const std::string& name, bool constrained) {
  Problem problem = bowl(name, 2, constrained);
  problem.smoothed = [plain = problem](double) { return plain; };
  problem.smoothing = 0.5;
  return problem;
}

/// Takes no constraints.
inline Solver chance(const std::string& name) {
  Solver solver;
  solver.name = name;
  solver.version = "1";
  solver.stochastic = true;
  solver.solve = [](Evaluator& evaluator, const Vector& start, Random& random) {
    Vector x = start;
    while (evaluator.objective(x)) x = uniform_point(evaluator.lower(), evaluator.upper(), random);
    return SolverTermination{"spent"};
  };
  return solver;
}

/// A bowl whose best point is not known before it is searched, which is counted where wanted.
inline SearchedProblem searched(const Problem& known, const std::shared_ptr<int>& searches) {
  Problem open = known;
  open.best_known.reset();
  open.best_point.reset();
  return {"bowl", open,
          [=] {
            if (searches) ++*searches;
            return Findings{{"best_point", (*known.best_point)[0]}};
          },
          [=](const Findings&) { return known; }};
}

inline Catalogue made_up_catalogue() {
  Catalogue catalogue;
  Problem open = bowl("bowl-open", 1);
  open.best_known.reset();
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
  catalogue.grid_keys = {{"restitution", {}},
                         {"friction", {}},
                         {"disturbance", {}},
                         {"fidelity", {"impact", "compliant", "planar"}}};
  catalogue.grid_problems = [](const MachineGrid& grid) {
    if (grid.around == "C99") throw InputError("there is no case C99");
    std::vector<SearchedProblem> problems;
    for (const double r : restitutions(grid)) {
      problems.push_back(
          searched(bowl("bowl-" + grid.around + "-" + std::to_string(r), 1), nullptr));
    }
    return problems;
  };
  return catalogue;
}

/// The same, that counts searches; of machines around "nowhere" only those below 1 are feasible.
inline Catalogue searched_catalogue(const std::shared_ptr<int>& searches) {
  Catalogue catalogue = made_up_catalogue();
  catalogue.grid_problems = [searches](const MachineGrid& grid) {
    std::vector<SearchedProblem> problems;
    for (const double r : restitutions(grid)) {
      problems.push_back(
          searched(bowl("bowl-" + grid.around + "-" + std::to_string(r), 1), searches));
      if (grid.around != "nowhere" || r < 1) continue;
      problems.back().search = [searches] { return ++*searches, Findings(); };
    }
    return problems;
  };
  catalogue.drawn_problem = [searches](const Problem& problem,
                                       int number) -> std::optional<SearchedProblem> {
    if (problem.dimension() > 1) return std::nullopt;
    return searched(bowl(problem.name + "~" + std::to_string(number), 1), searches);
  };
  return catalogue;
}

}  // namespace ricochet
