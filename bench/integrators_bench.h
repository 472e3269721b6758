#pragma once

namespace ricochet::bench {

/// Registers the measurements of all event-locating integrators on the same scenes with Google
/// Benchmark, so that one run gives their ratios.
void add_integrator_benchmarks();

}  // namespace ricochet::bench
