#include <ricochet/problem.h>
#include <ricochet/run.h>
#include <ricochet/solver.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

using namespace ricochet;

/// A solver of one's own: steps about the best point shown, shorter and shorter.
Solver shrinking_steps() {
  Solver solver;
  solver.name = "shrinking-steps";
  solver.stochastic = true;
  solver.solve = [](Evaluator& evaluator, const Vector& start,
                    Random& random) -> SolverTermination {
    const Vector box = evaluator.upper() - evaluator.lower();
    Vector x = start;
    for (double size = 1; evaluator.values(x) && size > 1e-6; size *= 0.98) {
      x = *evaluator.best_shown();
      for (Eigen::Index i = 0; i < x.size(); ++i) x[i] += size * (2 * uniform(random) - 1) * box[i];
    }
    return {"steps too short"};
  };
  return solver;
}

/// A problem of one's own: (x - 1)^2 + (y - 2)^2, smallest, 0, at (1, 2).
Problem bowl() {
  Problem problem;
  problem.name = "bowl";
  problem.lower = Vector::Constant(2, -5);
  problem.upper = Vector::Constant(2, 5);
  problem.start = Vector::Zero(2);
  problem.evaluate = [](const Vector& x) {
    return Values{std::pow(x[0] - 1, 2) + std::pow(x[1] - 2, 2), {}};
  };
  problem.best_known = 0;
  return problem;
}

/// Runs the solver and prints what the suite says of it; ends the program where it is not solved.
void solve(const Problem& problem, double tolerance) {
  const RunRecord record = run(problem, shrinking_steps(), Budget{20'000}, 0);
  const Verdict verdict = judge(record, problem, tolerance);
  std::printf("%s: %s, optimality gap %g\n", problem.name.c_str(),
              verdict.solved ? "solved" : "not solved", verdict.optimality_gap.value_or(-1));
  if (!verdict.solved) std::exit(1);
}

int main() {
  solve(bowl(), 1e-8);
  int asked = 0;
  for (const Family& family : all_families()) {
    if (family.name != "count") continue;
    for (const Problem& problem : family.problems) solve(problem, problem.tolerance);
    asked += static_cast<int>(family.problems.size());
  }
  return asked > 0 ? 0 : 1;
}
