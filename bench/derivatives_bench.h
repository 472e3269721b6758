#pragma once

namespace ricochet::bench {

/// Registers the measurements of gradients and Hessians with Google Benchmark, each with its cost
/// in values of the same function and with the allowed cost.
void add_derivative_benchmarks();

}  // namespace ricochet::bench
