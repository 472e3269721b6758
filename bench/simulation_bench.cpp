#include <benchmark/benchmark.h>

#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/benchmarks.h"
#include "problems/carrier_track/check/integrator.h"
#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/count_scan.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/counting/staircase.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/gradients/shape_derivatives.h"
#include "problems/carrier_track/regimes/border_curve.h"
#include "problems/carrier_track/suite/machine.h"
#include "problems/carrier_track/suite/robust.h"
#include "ricochet/machine.h"

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

namespace {

/// A free mass between two shaken walls, in the walls' frame: the symmetric orbit with two impacts
/// a period, stable for e = 0.5 and a gap of 5 amplitudes (from 2.6 to 9.6).
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

constexpr int rounds = 7;
constexpr double at_least = 5e-3;  // [s] per round

/// Measures the time of one simulation: `per_impact` [s], and `over_scan`, its ratio to that of one
/// of 64 speeds within 1 % that are counted at once in lanes.
void integration(benchmark::State& state, const Integrator& integrator, const Scene& scene,
                 double setting) {
  const Outcome outcome = integrator.run(scene, setting);
  if (!outcome.finished) return state.SkipWithError(outcome.failure.c_str());
  std::vector<double> speeds;
  for (int k = 0; k < 64; ++k) speeds.push_back(scene.omega * (0.995 + 1e-2 * k / 63));
  const auto [alone, scan] =
      fastest_of([&] { benchmark::DoNotOptimize(integrator.run(scene, setting)); },
                 [&] { benchmark::DoNotOptimize(counts_at(scene, speeds)); }, rounds, at_least);
  for (auto _ : state) benchmark::DoNotOptimize(integrator.run(scene, setting));
  state.counters["per_impact"] = alone / static_cast<double>(outcome.impacts.size());
  state.counters["over_scan"] = alone / (scan / static_cast<double>(speeds.size()));
}

}  // namespace

void add_integrator_benchmarks() {
  const std::vector<std::pair<std::string, Scene>> scenes = {{"C2/10", scene_for("C2", 10)},
                                                             {"shaken-gap", shaken_gap()}};
  for (const auto& [scene_name, scene] : scenes) {
    for (const Integrator& integrator : all_integrators()) {
      if (integrator.kind != "event location" && integrator.setting != no_setting) continue;
      for (const auto& [level, name] : {std::pair{1, "usual"}, {2, "tight"}}) {
        benchmark::RegisterBenchmark(
            ("integrate/" + scene_name + "/" + integrator.name + "/" + name).c_str(), integration,
            integrator, scene, integrator.levels[static_cast<std::size_t>(level)]);
      }
    }
  }
}

namespace {

/// Speeds of a scan at 1e-3 rad/s: 32 neighbours from every integer speed on.
std::vector<std::vector<double>> scanned_blocks() {
  std::vector<std::vector<double>> blocks;
  for (int whole = 1; whole < 18; ++whole) {
    std::vector<double>& block = blocks.emplace_back();
    for (int k = 0; k < 32; ++k) block.push_back(whole + 1e-3 * k);
  }
  return blocks;
}

/// `single_us` and `lanes_us`: time per simulation. `ratio`: how much faster lanes are.
void scan(benchmark::State& state, const Scene& scene) {
  const auto blocks = scanned_blocks();
  const auto [single, lanes] = fastest_of(
      [&] {
        for (const auto& block : blocks) {
          for (const double omega : block) benchmark::DoNotOptimize(count_at(scene, omega));
        }
      },
      [&] {
        for (const auto& block : blocks) benchmark::DoNotOptimize(counts_at(scene, block));
      },
      rounds, at_least);
  for (auto _ : state) benchmark::DoNotOptimize(counts_at(scene, blocks.front()));
  const double speeds = 32.0 * static_cast<double>(blocks.size());
  state.counters["single_us"] = 1e6 * single / speeds;
  state.counters["lanes_us"] = 1e6 * lanes / speeds;
  state.counters["ratio"] = single / lanes;
}

/// Time of the complete staircase to 1e-6 rad/s relative to an even scan at 1e-3 rad/s, both on one
/// processor.
void complete_scan(benchmark::State& state, const Scene& scene) {
  std::vector<double> speeds;
  for (int k = 100; k <= 18'000; ++k) speeds.push_back(1e-3 * k);
  std::int64_t simulations = 0;
  const auto [even, complete] = fastest_of(
      [&] { benchmark::DoNotOptimize(counts_at(scene, speeds)); },
      [&] { simulations = scan_completely(scene, 0.1, 18).value().simulations; }, rounds, at_least);
  for (auto _ : state) benchmark::DoNotOptimize(scan_completely(scene, 0.1, 18));
  state.counters["simulations"] = static_cast<double>(simulations);
  state.counters["over_even"] = complete / even;
}

/// Speedup by lanes of the objectives of the 32 sampled scenes of robust problems.
void draws(benchmark::State& state, const Scene& scene) {
  std::vector<Scene> scenes = sampled_scenes(scene);
  for (Scene& s : scenes) s.omega = 5;
  const auto [single, lanes] = fastest_of(
      [&] {
        for (const Scene& s : scenes) benchmark::DoNotOptimize(objective(s, 0.0));
      },
      [&] { benchmark::DoNotOptimize(objectives(scenes, 0.0)); }, rounds, at_least);
  for (auto _ : state) benchmark::DoNotOptimize(objectives(scenes, 0.0));
  state.counters["ratio"] = single / lanes;
}

/// Time of a count with its certainty, relative to the count alone.
void certainty(benchmark::State& state, const Scene& scene) {
  const auto at_all = [&](const auto& use) {
    for (int k = 1; k <= 60; ++k) use(at_speed(scene, 0.3 * k));
  };
  const auto [count, both] = fastest_of(
      [&] { at_all([](const Scene& s) { benchmark::DoNotOptimize(objective(s, 0.0)); }); },
      [&] { at_all([](const Scene& s) { benchmark::DoNotOptimize(record(s, 0, 0)); }); }, rounds,
      at_least);
  for (auto _ : state) benchmark::DoNotOptimize(record(at_speed(scene, 5.0), 0, 0));
  state.counters["over_count"] = both / count;
}

}  // namespace

void add_lanes_benchmarks() {
  for (const char* id : {"C1", "C2", "C4", "C9", "C12"}) {
    const Scene scene = scene_of(find_case(id), default_machine());
    const auto add = [&](const char* name, auto run) {
      benchmark::RegisterBenchmark((std::string(name) + id).c_str(), run, scene)
          ->Unit(benchmark::kMicrosecond);
    };
    add("lanes/scan/", scan);
    add("lanes/complete-scan/", complete_scan);
    add("lanes/robust/", draws);
    add("lanes/certainty/", certainty);
  }
}

namespace {

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
  const Border border = first_border(quiet, followed(quiet, quiet.omega() * 1.01));
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
