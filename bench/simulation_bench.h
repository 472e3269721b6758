#pragma once

namespace ricochet::bench {

/// Registers the measurements of the simulation with Google Benchmark.
void add_simulation_benchmarks();

}  // namespace ricochet::bench
