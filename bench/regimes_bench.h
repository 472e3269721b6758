#pragma once

namespace ricochet::bench {

/// Registers the regimes of the paper's cases, and curves of their borders.
void add_regime_benchmarks();

}  // namespace ricochet::bench
