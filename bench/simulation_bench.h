#pragma once

namespace ricochet::bench {

/// Registers the measurements of the simulation with Google Benchmark.
void add_simulation_benchmarks();

/// Registers the measurements of all event-locating integrators on the same scenes with Google
/// Benchmark, so that one run gives their ratios.
void add_integrator_benchmarks();

/// Registers the measurements of many simulations in lanes relative to as many single ones, and of
/// a certain count relative to a plain one.
void add_lanes_benchmarks();

/// Registers the regimes of the paper's cases, and curves of their borders.
void add_regime_benchmarks();

}  // namespace ricochet::bench
