#pragma once

namespace ricochet::bench {

/// Registers the measurements of the memory use of many simulations with Google Benchmark. They
/// take minutes.
void add_memory_benchmarks();

}  // namespace ricochet::bench
