#include "src/cli/bench.h"

#include <benchmark/benchmark.h>

#include "bench/derivatives_bench.h"
#include "bench/integrators_bench.h"
#include "bench/memory_bench.h"
#include "bench/simulation_bench.h"
#include "src/core/error.h"

namespace ricochet::cli {

int bench(std::vector<std::string> arguments, bool json) {
  if (json) arguments.push_back("--benchmark_format=json");
  arguments.insert(arguments.begin(), "ricochet bench");
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  auto argc = static_cast<int>(argv.size());
  bench::add_simulation_benchmarks();
  bench::add_derivative_benchmarks();
  bench::add_integrator_benchmarks();
  bench::add_memory_benchmarks();
  benchmark::Initialize(&argc, argv.data());
  if (argc > 1) {
    throw InputError(std::string("bench: unknown argument ") + argv[1] +
                     "; allowed: the flags of Google Benchmark, --benchmark_...");
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

}  // namespace ricochet::cli
