#include "bench/integrators_bench.h"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "problems/carrier_track/check/reference_integrators/integrator.h"
#include "problems/carrier_track/problems/cases.h"
#include "problems/carrier_track/problems/default_machine.h"

namespace ricochet::bench {
namespace {

using namespace carrier_track;

/// A loud case of the paper, with friction, rest and ends of Zeno sequences.
Scene loud_case() {
  Scene scene = scene_of(find_case("C2"), default_machine());
  scene.omega = 10.0;
  return scene;
}

/// A free mass between two shaken walls, in the walls' frame: the symmetric orbit with two impacts
/// a period, stable for e = 0.5 and a gap of 5 amplitudes (2.6 to 9.6; contact.md).
Scene shaken_gap() {
  const double amplitude = 2e-4;                         // [m]
  const double frequency = 2 * std::numbers::pi * 10.0;  // [rad/s]
  Scene scene;
  scene.wall_upper = 5 * amplitude;
  scene.restitution_lower = scene.restitution_upper = 0.5;
  scene.disturbance = scene.mass * amplitude * frequency * frequency;
  scene.disturbance_frequency = frequency;
  scene.start_position = 0.5 * scene.wall_upper;
  scene.start_velocity = 0.03;  // fast enough to reach a wall
  scene.window = Seconds{10.0};
  return scene;
}

/// Measures the time of one simulation. per_impact [s] divides it by the impacts that the method
/// detected; evaluations_per_impact counts evaluations of the forces (event-driven: of the
/// closed-form flight).
void integration(benchmark::State& state, const Integrator& integrator, const Scene& scene,
                 double control) {
  std::size_t impacts = 0;
  std::int64_t evaluations = 0;
  for (auto _ : state) {
    const Outcome outcome = integrator.run(scene, control);
    if (!outcome.finished) {
      state.SkipWithError(outcome.failure.c_str());
      return;
    }
    impacts += outcome.impacts.size();
    evaluations += outcome.force_evaluations;
  }
  const auto count = static_cast<double>(impacts);
  state.counters["per_impact"] =
      benchmark::Counter(count, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["evaluations_per_impact"] = static_cast<double>(evaluations) / count;
  state.counters["impacts"] = benchmark::Counter(count, benchmark::Counter::kAvgIterations);
}

}  // namespace

void add_integrator_benchmarks() {
  const std::vector<std::pair<std::string, Scene>> scenes = {{"C2/10", loud_case()},
                                                             {"shaken-gap", shaken_gap()}};
  for (const auto& [scene_name, scene] : scenes) {
    for (const Integrator& integrator : all_integrators()) {
      const std::string name = "integrate/" + scene_name + "/" + integrator.name;
      if (integrator.control == "none") {
        benchmark::RegisterBenchmark(name.c_str(), integration, integrator, scene, 0.0);
      }
      if (integrator.control != "relative tolerance") continue;
      for (const auto& [tolerance_name, tolerance] : {std::pair{"1e-6", 1e-6}, {"1e-12", 1e-12}}) {
        benchmark::RegisterBenchmark((name + "/" + tolerance_name).c_str(), integration, integrator,
                                     scene, tolerance);
      }
    }
  }
}

}  // namespace ricochet::bench
