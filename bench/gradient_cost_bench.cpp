#include "bench/gradient_cost_bench.h"

#include <benchmark/benchmark.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "bench/processor_time.h"
#include "problems/families.h"
#include "src/core/instance.h"
#include "src/core/random.h"

namespace ricochet::bench {
namespace {

/// The problem in the first of its forms that has derivatives, as stated or smoothed.
std::optional<Problem> with_derivatives(const Question& question) {
  for (const Form& form : question.forms()) {
    const Problem problem = question.problem(form);
    if (problem.differentiate || problem.residuals) return problem;
  }
  return std::nullopt;
}

/// Over the start and points uniform in the box, both at their fastest and by turns, as other work
/// on the machine slows now this and now that.
void cost(benchmark::State& state, const Question& question, const Problem& problem) {
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
      question.gradient_cost ? static_cast<double>(*question.gradient_cost) : n;
  state.counters["n"] = n;
}

}  // namespace

void add_gradient_cost_benchmarks() {
  for (const Family& family : all_families()) {
    std::set<Eigen::Index> sizes;
    for (const Question& question : family.questions) {
      const auto problem = with_derivatives(question);
      if (!problem || !sizes.insert(problem->dimension()).second) continue;
      benchmark::RegisterBenchmark(
          ("gradient-cost/" + question.name()).c_str(),
          [question, problem](benchmark::State& state) { cost(state, question, *problem); })
          ->Unit(benchmark::kMicrosecond);
    }
  }
}

}  // namespace ricochet::bench
