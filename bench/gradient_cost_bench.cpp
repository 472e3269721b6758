#include "bench/gradient_cost_bench.h"

#include <benchmark/benchmark.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "bench/processor_time.h"
#include "ricochet/random.h"
#include "src/core/instance.h"
#include "src/research/suite/families.h"

namespace ricochet::bench {
namespace {

/// The problem in the first of its formulations that has derivatives, original or smoothed.
std::optional<Problem> with_derivatives(const Problem& problem) {
  for (const Formulation& formulation : problem.formulations()) {
    const Problem formulated = problem.formulated(formulation);
    if (formulated.differentiate || formulated.residuals) return formulated;
  }
  return std::nullopt;
}

/// Measures over the start and points uniform in the box. Both times are the fastest of several
/// rounds, measured alternately, because other work slows the machine at times.
void cost(benchmark::State& state, const Problem& problem) {
  Random random(1);
  std::vector<Vector> points = {problem.start};
  for (int k = 0; k < 4; ++k) points.push_back(uniform_point(problem, random));
  const auto value = [&] {
    for (const Vector& x : points) benchmark::DoNotOptimize(problem.evaluate(x));
  };
  const auto both = [&] {
    for (const Vector& x : points) {
      if (problem.differentiate) {
        benchmark::DoNotOptimize(problem.differentiate(x));
      } else {
        benchmark::DoNotOptimize(problem.residuals(x));
      }
    }
  };
  const auto [of_value, of_both] = fastest_of(value, both, 5, 1e-3);
  for (auto _ : state) both();
  const double n = static_cast<double>(problem.dimension());
  state.counters["gradient"] = of_both / of_value - 1;
  state.counters["charged"] =
      problem.gradient_cost ? static_cast<double>(*problem.gradient_cost) : n;
  state.counters["n"] = n;
}

}  // namespace

void add_gradient_cost_benchmarks() {
  for (const Family& family : suite_families()) {
    std::set<Eigen::Index> sizes;
    for (const Problem& problem : family.problems) {
      const auto formulated = with_derivatives(problem);
      if (!formulated || !sizes.insert(problem.dimension()).second) continue;
      benchmark::RegisterBenchmark(
          ("gradient-cost/" + problem.name).c_str(),
          [formulated](benchmark::State& state) { cost(state, *formulated); })
          ->Unit(benchmark::kMicrosecond);
    }
  }
}

}  // namespace ricochet::bench
