#include "bench/regimes_bench.h"

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "bench/processor_time.h"
#include "problems/carrier_track/counting/counts.h"
#include "problems/carrier_track/problems/cases.h"
#include "problems/carrier_track/problems/default_machine.h"
#include "problems/carrier_track/regimes/border_curve.h"
#include "ricochet/regimes.h"

namespace ricochet::bench {
namespace {

using namespace carrier_track;

constexpr int regime_rounds = 5;
constexpr double regime_time = 5e-3;  // [s] per round

/// `regimes_ms`: processor time of all regimes up to 18 rad/s. `over_scan`: relative to counting
/// the window at 18,000 even speeds in lanes.
void regimes(benchmark::State& state, const Scene& scene) {
  std::vector<double> speeds;
  for (int k = 1; k <= 18'000; ++k) speeds.push_back(1e-3 * k);
  const auto [found, scan] = fastest_of([&] { benchmark::DoNotOptimize(regimes_of(scene)); },
                                        [&] { benchmark::DoNotOptimize(counts_at(scene, speeds)); },
                                        regime_rounds, regime_time);
  for (auto _ : state) benchmark::DoNotOptimize(regimes_of(scene));
  state.counters["regimes_ms"] = 1e3 * found;
  state.counters["over_scan"] = found / scan;
}

/// Points per second of the border beyond which a turn has more than two collisions, over the
/// restitution.
void curve(benchmark::State& state, const Scene& scene) {
  constexpr int points = 100;
  const SteadyMotion quiet = steady_motion(at_speed(scene, *quiet_up_to(scene, 2) * (1 - 1e-3)));
  const Border<SteadyMotion> border = first_border(quiet, followed(quiet, quiet.omega() * 1.01));
  for (auto _ : state) {
    BorderCurve curve(border, "restitution");
    const double from = curve.here().constant;
    for (int k = 1; k <= points; ++k) {
      if (!curve.follow_to(from * (1 + 1e-3 * k))) state.SkipWithError("the border ends");
    }
    benchmark::DoNotOptimize(curve.here());
  }
  state.SetItemsProcessed(state.iterations() * points);
}

}  // namespace

void add_regime_benchmarks() {
  for (const Case& a_case : all_cases()) {
    const Scene scene = scene_of(a_case, default_machine());
    benchmark::RegisterBenchmark(("regimes/" + a_case.id).c_str(),
                                 [scene](benchmark::State& state) { regimes(state, scene); });
    if (scene.disturbance != 0) continue;
    benchmark::RegisterBenchmark(("border-curve/" + a_case.id).c_str(),
                                 [scene](benchmark::State& state) { curve(state, scene); });
  }
}

}  // namespace ricochet::bench
