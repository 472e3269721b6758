#pragma once

namespace ricochet::bench {

/// Registers the measurements of the operations of a flight one after another (latency) and side by
/// side (throughput): the limits of what a simulation can reach.
void add_roofline_benchmarks();

}  // namespace ricochet::bench
