#include "ricochet/run.h"

#include <algorithm>
#include <limits>
#include <new>
#include <utility>

#include "ricochet/evaluator.h"
#include "src/core/evaluator.h"
#include "src/core/floating_point.h"
#include "src/core/instance.h"

namespace ricochet {

namespace {

/// A run ends after this many starts in a row without a new evaluation. A single one may happen by
/// chance, if a solver moves its start to the point evaluated last.
constexpr int idle_starts = 10;

std::string message_of(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const std::bad_alloc&) {
    return "out of memory";
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "an exception that is not a std::exception";
  }
}

/// The points that the starts returned, projected onto the box.
std::vector<Vector> candidates(const Problem& problem, const RunRecord& record) {
  std::vector<Vector> points;
  for (const SolverTermination& exit : record.terminations) {
    if (!exit.point || exit.point->size() != problem.dimension() || !exit.point->allFinite()) {
      continue;
    }
    const Vector inside = exit.point->cwiseMax(problem.lower).cwiseMin(problem.upper);
    if (points.empty() || points.back() != inside) points.push_back(inside);
  }
  return points;
}

/// Sets the returned point: of the candidates, the one with the best values in this formulation.
/// Returns the problem's exception, or null.
std::exception_ptr hand_over(const Problem& problem, RunRecord& record) {
  try {
    const std::vector<Vector> points = candidates(problem, record);
    if (points.empty()) return nullptr;
    const Vector* best = &points.front();
    if (points.size() > 1) {
      TrueValues best_shown{std::numeric_limits<double>::infinity(),
                            std::numeric_limits<double>::infinity()};
      for (const Vector& point : points) {
        const TrueValues shown = true_values_of(problem.evaluate(point), problem.equalities);
        if (!better(shown, best_shown)) continue;
        best_shown = shown;
        best = &point;
      }
    }
    const bool known = !record.trace.empty() && record.trace.back().x == *best;
    record.returned = {*best,
                       known ? record.trace.back().true_values : true_values_at(problem, *best)};
  } catch (...) {
    return std::current_exception();
  }
  return nullptr;
}

}  // namespace

RunRecord nothing_run(const Problem& problem, const Solver& solver, const Budget& budget,
                      int number, std::string_view shown) {
  RunRecord record;
  record.problem = problem.name;
  record.solver = solver.name;
  record.instance = problem.instance;
  record.run = number;
  record.seed = seed_of(problem.name, solver.name, problem.instance, number, shown);
  record.budget = budget;
  return record;
}

RunRecord run(const Problem& problem, const Solver& solver, const Budget& budget, int number,
              std::function<void(const Improvement&)> on_improvement, std::string_view shown) {
  RunRecord record = nothing_run(problem, solver, budget, number, shown);
  Random random(record.seed);
  Random starts(seed_of(problem.name, "start", problem.instance, number));
  Scorer scorer(problem, std::move(on_improvement));
  Evaluator evaluator(problem, budget, &scorer);
  std::exception_ptr failure;
  try {
    const bool stated = number == 0 || !problem.start_scales.empty();
    Vector start = stated ? problem.start : uniform_point(problem, starts);
    int idle = 0;
    while (!evaluator.over() && idle < idle_starts) {
      const std::int64_t before = evaluator.ledger().charged;
      SolverTermination exit = solver.solve(evaluator, start, random);
      reset_floating_point();
      if (evaluator.ledger().charged == before) {
        exit.point.reset();  // a start that evaluated nothing has nothing to return
      } else if (!exit.point && evaluator.best_shown() != nullptr) {
        exit.point = *evaluator.best_shown();
      }
      record.terminations.push_back(std::move(exit));
      start = uniform_point(problem, starts);
      idle = evaluator.ledger().charged > before ? 0 : idle + 1;
    }
  } catch (...) {
    failure = std::current_exception();
    reset_floating_point();
  }
  record.ledger = evaluator.ledger();
  record.termination_reason = evaluator.termination_reason();
  record.trace = scorer.trace();
  if (!failure) failure = evaluator.failure();
  if (!failure) failure = hand_over(problem, record);
  if (failure) record.failure = message_of(failure);
  return record;
}

}  // namespace ricochet
