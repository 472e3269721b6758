#pragma once

namespace ricochet::bench {

/// Registers with Google Benchmark, of every family whose problems have derivatives and of every
/// number of variables, what a gradient takes beside the value, in evaluations, and what it is
/// charged under the price "measured": Question::gradient_cost.
void add_gradient_cost_benchmarks();

}  // namespace ricochet::bench
