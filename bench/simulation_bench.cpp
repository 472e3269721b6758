#include "bench/simulation_bench.h"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/gradients/surrogate.h"
#include "problems/carrier_track/problems/cases.h"
#include "problems/carrier_track/problems/default_machine.h"
#include "ricochet/recording.h"

namespace ricochet::bench {
namespace {

using namespace carrier_track;

struct ImpactCounter : Observer {
  std::int64_t impacts = 0;
  void impact(double /*time*/, Wall /*wall*/, double /*speed*/) { ++impacts; }
};

Scene scene_for(const std::string& case_id, double omega) {
  Scene scene = scene_of(find_case(case_id), default_machine());
  scene.omega = omega;
  return scene;
}

/// Time of one simulation, per impact and per evaluation of the flight.
void simulation(benchmark::State& state, const Scene& scene) {
  ImpactCounter counter;
  std::int64_t evaluations = 0;
  for (auto _ : state) {
    const End<double> end = simulate(scene, counter);
    evaluations += end.evaluations;
    benchmark::DoNotOptimize(evaluations);
  }
  const auto rate = [](std::int64_t count) {
    return benchmark::Counter(static_cast<double>(count),
                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  };
  state.counters["per_impact"] = rate(counter.impacts);
  state.counters["per_evaluation"] = rate(evaluations);
}

void surrogate_value(benchmark::State& state, const Scene& scene) {
  for (auto _ : state) benchmark::DoNotOptimize(objective(scene, default_smoothing));
}

void surrogate_gradient(benchmark::State& state, const Scene& scene) {
  for (auto _ : state) benchmark::DoNotOptimize(surrogate_slope(scene, default_smoothing));
}

/// Time of a complete threshold: 18,000 speeds on every core.
void whole_threshold(benchmark::State& state, const Case& a_case) {
  const Scene scene = scene_of(a_case, default_machine());
  for (auto _ : state) benchmark::DoNotOptimize(score(scene, a_case.claim, ScanOptions{}));
}

}  // namespace

void add_simulation_benchmarks() {
  for (const char* id : {"C1", "C2", "C4", "C9"}) {
    for (const double omega : {3.0, 10.0}) {
      const Scene scene = scene_for(id, omega);
      const std::string name = std::string(id) + "/" + std::to_string(static_cast<int>(omega));
      benchmark::RegisterBenchmark(("simulate/" + name).c_str(), simulation, scene);
      benchmark::RegisterBenchmark(("surrogate/" + name).c_str(), surrogate_value, scene);
      benchmark::RegisterBenchmark(("gradient/" + name).c_str(), surrogate_gradient, scene);
    }
    benchmark::RegisterBenchmark((std::string("threshold/") + id).c_str(), whole_threshold,
                                 find_case(id))
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
  }
}

}  // namespace ricochet::bench
