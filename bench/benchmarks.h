#pragma once

#include <algorithm>
#include <limits>
#include <utility>

#include "src/core/time_limit.h"

namespace ricochet::bench {

/// Registers the measurements of gradients and Hessians with Google Benchmark, each with its cost
/// in values of the same function and with the allowed cost.
void add_derivative_benchmarks();

/// Registers with Google Benchmark the cost of a gradient beside the value, in evaluations, for
/// every family whose problems have derivatives and every number of variables, and what the price
/// "measured" charges for it: Problem::gradient_cost.
void add_gradient_cost_benchmarks();

/// Registers with Google Benchmark the derivatives with respect to the shape of a speed profile, by
/// the adjoint method and by dual numbers, each with its cost in values of the same function.
void add_shape_benchmarks();

/// Registers the measurements of the simulation with Google Benchmark.
void add_simulation_benchmarks();

/// Registers the measurements of all event-locating integrators on the same scenes with Google
/// Benchmark, each beside a scan in lanes.
void add_integrator_benchmarks();

/// Registers the measurements of many simulations in lanes relative to as many single ones, and of
/// a certain count relative to a plain one.
void add_lanes_benchmarks();

/// Registers the regimes of the paper's cases, and curves of their borders.
void add_regime_benchmarks();

/// Registers the measurements of the memory use of many simulations with Google Benchmark. They
/// take minutes.
void add_memory_benchmarks();

/// Registers the measurements of the overhead of an evaluation: the evaluator's own time, and that
/// of every solver with it, in one variable, on a function that costs nothing.
void add_overhead_benchmarks();

/// Registers the measurements of the operations of a flight one after another (latency) and side by
/// side (throughput): the limits of what a simulation can reach.
void add_roofline_benchmarks();

/// Processor time [s] of this thread for one call of `work`: the mean over at least `at_least` [s].
template <class Work>
double processor_time(const Work& work, double at_least) {
  int calls = 0;
  const double start = processor_seconds();
  double passed = 0;
  do {
    work();
    ++calls;
    passed = processor_seconds() - start;
  } while (passed < at_least);
  return passed / calls;
}

/// The fastest processor time [s] of each, of `rounds` rounds of at least `at_least` [s], measured
/// alternately, because other work slows the machine at times.
template <class One, class Other>
std::pair<double, double> fastest_of(const One& one, const Other& other, int rounds,
                                     double at_least) {
  double of_one = std::numeric_limits<double>::infinity();
  double of_other = of_one;
  for (int i = 0; i < rounds; ++i) {
    of_one = std::min(of_one, processor_time(one, at_least));
    of_other = std::min(of_other, processor_time(other, at_least));
  }
  return {of_one, of_other};
}

}  // namespace ricochet::bench
