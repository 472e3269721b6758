#include "bench/lanes_bench.h"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>
#include <vector>

#include "bench/processor_time.h"
#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/counting/complete_scan.h"
#include "problems/carrier_track/counting/counts.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/problems/cases.h"
#include "problems/carrier_track/problems/default_machine.h"
#include "problems/carrier_track/problems/robust.h"

namespace ricochet::bench {
namespace {

using namespace carrier_track;

constexpr int rounds = 7;
constexpr double at_least = 5e-3;  // [s] per round

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

}  // namespace ricochet::bench
