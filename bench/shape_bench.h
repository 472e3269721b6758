#pragma once

namespace ricochet::bench {

/// Registers with Google Benchmark the derivatives with respect to the shape of a speed profile, by
/// the adjoint method and by dual numbers, each with its cost in values of the same function.
void add_shape_benchmarks();

}  // namespace ricochet::bench
