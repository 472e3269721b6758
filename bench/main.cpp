#include <benchmark/benchmark.h>

#include <cstdio>

#include "bench/derivatives_bench.h"
#include "bench/integrators_bench.h"
#include "bench/memory_bench.h"
#include "bench/simulation_bench.h"

/// The program that `ricochet bench` runs; it takes the flags of Google Benchmark alone.
int main(int argc, char** argv) {
  ricochet::bench::add_simulation_benchmarks();
  ricochet::bench::add_derivative_benchmarks();
  ricochet::bench::add_integrator_benchmarks();
  ricochet::bench::add_memory_benchmarks();
  benchmark::Initialize(&argc, argv);
  if (argc > 1) {
    std::fprintf(stderr,
                 "ricochet: bench: unknown argument %s; allowed: the flags of Google Benchmark, "
                 "--benchmark_...\n",
                 argv[1]);
    return 2;
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
