#include "bench/memory_bench.h"

#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/problems/cases.h"
#include "problems/carrier_track/problems/default_machine.h"

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

}  // namespace ricochet::bench
