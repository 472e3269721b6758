#pragma once

namespace ricochet::bench {

/// Registers with Google Benchmark the cost of a gradient beside the value, in evaluations, for
/// every family whose problems have derivatives and every number of variables, and what the price
/// "measured" charges for it: Problem::gradient_cost.
void add_gradient_cost_benchmarks();

}  // namespace ricochet::bench
