#include "bench/overhead_bench.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

#include "ricochet/run.h"
#include "ricochet/solvers.h"
#include "src/core/instance.h"
#include "src/core/scorer.h"

namespace ricochet::bench {
namespace {

/// |x| on [-1, 2], with derivatives.
Problem free_function() {
  Problem problem;
  problem.name = "free";
  problem.lower = Vector::Constant(1, -1);
  problem.upper = Vector::Constant(1, 2);
  problem.start = Vector::Constant(1, 1.5);
  problem.best_known = 0.0;
  problem.best_point = Vector::Zero(1);
  problem.evaluate = [](const Vector& x) { return Values{std::abs(x[0]), {}}; };
  problem.differentiate = [](const Vector& x) {
    return Derivatives{{std::abs(x[0]), {}}, Vector::Constant(1, x[0] < 0 ? -1 : 1), Matrix(0, 1)};
  };
  return problem;
}

void evaluator(benchmark::State& state, const Problem& problem) {
  Scorer scorer(problem);
  Evaluator evaluator(problem, {std::numeric_limits<std::int64_t>::max()}, &scorer);
  Vector x = problem.start;
  for (auto _ : state) {
    x = problem.lower + problem.upper - x;  // another point every time
    benchmark::DoNotOptimize(evaluator.values(x));
  }
}

/// Time per charged evaluation.
void solver(benchmark::State& state, const Solver& solver) {
  constexpr std::int64_t budget = 1000;
  const Problem problem = free_function();
  int number = 0;
  std::int64_t evaluations = 0;
  for (auto _ : state) evaluations += run(problem, solver, {budget}, number++).ledger.charged;
  state.counters["per_evaluation"] = benchmark::Counter(
      static_cast<double>(evaluations), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

}  // namespace

void add_overhead_benchmarks() {
  for (const int number : {0, 1}) {
    const auto name = fmt::format("overhead/evaluator/{}", number == 0 ? "stated" : "instance");
    benchmark::RegisterBenchmark(name.c_str(), evaluator, instance(free_function(), number));
  }
  for (const Solver& each : all_solvers()) {
    if (!each.accepts(free_function())) continue;
    benchmark::RegisterBenchmark(("overhead/" + each.name).c_str(), solver, each);
  }
}

}  // namespace ricochet::bench
