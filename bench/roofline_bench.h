#pragma once

namespace ricochet::bench {

/// What the operations of a flight cost one after another (latency) and side by side (throughput):
/// the limits of what a simulation can reach.
void add_roofline_benchmarks();

}  // namespace ricochet::bench
