#pragma once

namespace ricochet::bench {

/// Registers the measurements of the overhead of an evaluation: the evaluator's own time, and that
/// of every solver with it, in one variable, on a function that costs nothing.
void add_overhead_benchmarks();

}  // namespace ricochet::bench
