#include "bench/roofline_bench.h"

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "problems/carrier_track/flight/flight.h"
#include "problems/carrier_track/models/lanes.h"

namespace ricochet::bench {
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
