#pragma once

namespace ricochet::bench {

/// What an evaluation costs beside the function: the evaluator's own time, and that of every solver
/// with it, in one variable, of a function that is free.
void add_overhead_benchmarks();

}  // namespace ricochet::bench
