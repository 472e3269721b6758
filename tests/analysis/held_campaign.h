#pragma once

#include "ricochet/problem.h"
#include "ricochet/solver.h"
#include "src/analysis/results.h"
#include "src/experiment/planned_runs.h"
#include "tests/core/best_point_of.h"
#include "tests/support/files.h"
#include "tests/support/problems.h"

namespace ricochet::comparison {

/// |x - 0.5| on [0, 1]; at a smoothing parameter its best point is moved up by the smoothing
/// parameter, and it has derivatives.
inline Problem valley(double smoothing) {
  Problem problem = box_problem("valley", 1, 0, 1, 0, [smoothing](const Vector& x) {
    return std::abs(x[0] - 0.5 - smoothing);
  });
  problem.best_known = 0.0;
  problem.best_point = Vector::Constant(1, 0.5);
  problem.true_values = [](const Vector& x) { return TrueValues{std::abs(x[0] - 0.5), 0}; };
  if (smoothing > 0) {
    differentiate_by(problem, [smoothing](const Vector& x) -> Vector {
      return Vector::Constant(1, x[0] > 0.5 + smoothing ? 1 : -1);
    });
  }
  problem.smoothed = valley;
  return problem;
}

inline Problem valley_problem() {
  Problem problem = valley(0);
  problem.smoothing = 0.25;
  problem.tolerance = 1e-9;
  problem.scan_step = 1e-3;
  return problem;
}

/// Asks for `wasted` points at the lower end, then for the best point, and returns the end; or the
/// best point, if it got that far and `returns_best`.
inline Solver patient(std::string name, int wasted, bool needs_derivatives = false,
                      bool returns_best = false) {
  Solver solver;
  solver.name = std::move(name);
  if (needs_derivatives) solver.capabilities.derivatives = Capabilities::Order::gradient;
  solver.solve = [=](Evaluator& evaluator, const Vector&, Random&) {
    for (int i = 0; i < wasted; ++i) evaluator.objective(evaluator.lower());
    Problem known = valley(0);
    known.name = evaluator.name();
    const Vector best = best_point_of(known, evaluator);
    const bool evaluated = evaluator.objective(best).has_value();
    return SolverTermination{"done", evaluated && returns_best ? best : evaluator.lower()};
  };
  return solver;
}

/// A campaign whose runs are made.
class HeldCampaign : public TemporaryFolder {
 protected:
  /// Of these solvers on these problems. Each of the parts of the plan, given without problems and
  /// solvers, has all.
  void hold(std::vector<Solver> solvers, const std::vector<std::string>& parts,
            const Shard& shard = {}, const std::vector<Problem>& problems = {valley_problem()}) {
    Catalogue catalogue;
    catalogue.families = {{"valley", problems}};
    catalogue.solvers = std::move(solvers);
    std::string plan;
    for (const std::string& part : parts) {
      plan += "[[part]]\nproblems = \"*\"\nsolvers = \"*\"\n" + part;
    }
    campaign_.emplace(plan_from(plan, "test"), catalogue);
    store_.emplace(Store::create(folder_ / "runs.sqlite", campaign_->description()));
    make_runs(*campaign_, shard, *store_);
  }

  std::vector<CellResult> results() const { return cell_results(*campaign_, *store_); }

  std::optional<Campaign> campaign_;
  std::optional<Store> store_;
};

}  // namespace ricochet::comparison
