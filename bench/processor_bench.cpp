#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/benchmarks.h"
#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/motion/flight.h"
#include "problems/carrier_track/motion/lanes.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "src/core/evaluator.h"
#include "src/core/instance.h"

namespace ricochet::bench {

namespace {

using namespace carrier_track;

/// The current resident set [kB].
double resident() {
  std::ifstream statistics("/proc/self/statm");
  std::int64_t size = 0;
  std::int64_t pages = 0;
  if (!(statistics >> size >> pages)) throw std::runtime_error("cannot read /proc/self/statm");
  return static_cast<double>(pages * sysconf(_SC_PAGESIZE)) / 1024;
}

/// The largest resident set of this program so far [kB].
double largest_resident() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss);
}

/// The paper's cases, at speeds so low that one simulation takes microseconds.
std::vector<Scene> quiet_scenes(Fidelity fidelity) {
  std::vector<Scene> scenes;
  for (const Case& a_case : all_cases()) {
    scenes.push_back(scene_of(a_case, default_machine()));
    scenes.back().fidelity = fidelity;
  }
  return scenes;
}

/// Growth of the resident set over many evaluations of the objective, each at another speed. The
/// first hundredth is left out: what is set up once is no growth.
void memory(benchmark::State& state, Fidelity fidelity, std::int64_t evaluations) {
  std::vector<Scene> scenes = quiet_scenes(fidelity);
  const std::int64_t warm_up = evaluations / 100;
  double before = 0;
  for (auto _ : state) {
    for (std::int64_t k = 0; k < evaluations; ++k) {
      if (k == warm_up) before = resident();
      Scene& scene = scenes[static_cast<std::size_t>(k) % scenes.size()];
      scene.omega = 0.5 + static_cast<double>(k) / static_cast<double>(evaluations);  // [rad/s]
      benchmark::DoNotOptimize(objective(scene, 0.0));
    }
  }
  state.counters["evaluations"] = static_cast<double>(evaluations);
  state.counters["growth_kB"] = resident() - before;
  state.counters["largest_kB"] = largest_resident();
}

}  // namespace

void add_memory_benchmarks() {
  const auto add = [](const char* name, Fidelity fidelity, std::int64_t evaluations) {
    benchmark::RegisterBenchmark(name, memory, fidelity, evaluations)
        ->Iterations(1)
        ->Unit(benchmark::kSecond);
  };
  add("memory/1e7-evaluations", Fidelity::impact, 10'000'000);
  add("memory/1e5-evaluations-compliant", Fidelity::compliant, 100'000);
}

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

namespace {

using carrier_track::Flight;
using carrier_track::Lanes;

/// Applies `step` to one number repeatedly; each call waits for the one before.
template <class Step>
void latency(benchmark::State& state, const Step& step) {
  double x = 1.25;
  for (auto _ : state) {
    for (int i = 0; i < 64; ++i) x = step(x);
    benchmark::DoNotOptimize(x);
  }
  state.counters["each"] = benchmark::Counter(
      64, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Applies `step` to 64 independent numbers.
template <class Step>
void throughput(benchmark::State& state, const Step& step) {
  std::array<double, 64> all;
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = 1 + 0.01 * static_cast<double>(i);
  for (auto _ : state) {
    for (double& x : all) x = step(x);
    benchmark::DoNotOptimize(all);
  }
  state.counters["each"] = benchmark::Counter(
      64, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <class Step>
void add(const std::string& name, Step step) {
  benchmark::RegisterBenchmark(("roofline/latency/" + name).c_str(),
                               [step](benchmark::State& state) { latency(state, step); });
  benchmark::RegisterBenchmark(("roofline/throughput/" + name).c_str(),
                               [step](benchmark::State& state) { throughput(state, step); });
}

/// One evaluation of a flight, whose forcing turns by about a tenth of a radian, as in most
/// flights.
double evaluated(double x) {
  Flight<double> flight{1e-3, 0.1, -3, {}, 1};
  flight.harmonic[0] = {1, 0.5, 5};
  flight.advance(0.016 * x);
  return 1 + flight.position + flight.acceleration();
}

/// Flights from event to event, four bodies per call: chattering on a wall.
void flights(benchmark::State& state) {
  Lanes lanes;
  lanes.harmonics = 1;
  lanes.steady.fill(-3);
  lanes.friction.fill(0.3);
  lanes.frequency[0].fill(5);
  lanes.cosine[0].fill(1);
  lanes.restitution_lower.fill(0.5);
  lanes.wall_upper.fill(2e-3);
  lanes.duration.fill(1e9);
  lanes.velocity.fill(0.05);
  lanes.direction.fill(1);
  const Lanes start = lanes;
  double evaluations = 0;
  for (auto _ : state) {
    lanes = start;
    for (int i = 0; i < 4; ++i) fly(lanes);
    benchmark::DoNotOptimize(lanes);
    evaluations += 4 * lanes.evaluations[0];
  }
  const auto each = benchmark::Counter::kIsRate | benchmark::Counter::kInvert;
  state.counters["each"] = benchmark::Counter(evaluations, each);
}

}  // namespace

void add_roofline_benchmarks() {
  add("multiply-add", [](double x) { return x * 0.999 + 0.001; });
  add("division", [](double x) { return 1.5 / x; });
  add("root", [](double x) { return std::sqrt(x); });
  add("sincos", [](double x) { return 1 + std::sin(x) * std::cos(x); });
  add("evaluation", evaluated);
  benchmark::RegisterBenchmark("roofline/reached/lanes", flights);
}

}  // namespace ricochet::bench
