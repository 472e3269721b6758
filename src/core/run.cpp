#include "src/core/run.h"

#include "src/core/instance.h"

namespace ricochet {
namespace {

std::string message_of(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "an exception that is not a std::exception";
  }
}

}  // namespace

RunRecord run(const Problem& problem, const Solver& solver, const Budget& budget, int number) {
  RunRecord record;
  record.problem = problem.name;
  record.solver = solver.name;
  record.instance = problem.instance;
  record.run = number;
  record.seed = seed_of(problem.name, solver.name, problem.instance, number);
  record.budget = budget;
  Random random(record.seed);
  Random starts(seed_of(problem.name, "start", problem.instance, number));
  Evaluator evaluator(problem, budget);
  std::exception_ptr failure;
  try {
    Vector start = number == 0 ? problem.start : uniform_point(problem, starts);
    std::int64_t before = -1;
    while (!evaluator.over() && evaluator.ledger().charged > before) {
      before = evaluator.ledger().charged;
      record.exits.push_back(solver.solve(evaluator, start, random));
      start = uniform_point(problem, starts);
    }
  } catch (...) {
    failure = std::current_exception();
  }
  if (evaluator.failure()) failure = evaluator.failure();
  if (failure) record.failure = message_of(failure);
  record.ledger = evaluator.ledger();
  record.refusal = evaluator.refusal();
  record.trace = evaluator.trace();
  return record;
}

}  // namespace ricochet
