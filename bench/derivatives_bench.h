#pragma once

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

}  // namespace ricochet::bench
