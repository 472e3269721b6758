#pragma once

namespace ricochet::bench {

/// Registers the measurements of many simulations in lanes relative to as many single ones, and of
/// a certain count relative to a plain one.
void add_lanes_benchmarks();

}  // namespace ricochet::bench
