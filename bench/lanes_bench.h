#pragma once

namespace ricochet::bench {

/// What many simulations side by side cost beside as many single ones, and certainty beside a
/// count.
void add_lanes_benchmarks();

}  // namespace ricochet::bench
