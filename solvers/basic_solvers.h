#pragma once

#include <cstdint>

#include "ricochet/solver.h"

namespace ricochet {

/// Bisection, as an engineer would do it by hand: if the end of the box with the best objective is
/// infeasible, halves the interval between it and the other end until it encloses the limit of the
/// feasible set. For one variable, with inequalities. The start is the first point tried between
/// the ends; if there are several limits, another start may find another one.
Solver bisection();

/// Golden-section search (Kiefer 1953, doi 10.2307/2032161) for one variable without constraints:
/// keeps an interval and a point inside it that is no worse than the ends, and tries the golden
/// section of the longer part. The first interval is the box, the first inner point the start.
Solver golden_section();

/// "scan": for one dimension, an exhaustive scan that does not need to know its budget: both ends
/// of the box, then the van der Corput points in base 2, each halving a widest gap. After 2^k + 1
/// evaluations the points are an even grid. It ignores the start and does not compare points
/// itself, so it takes any constraints.
Solver scan();

/// The k-th van der Corput number in base 2, in [0, 1): the binary digits of k mirrored at the
/// binary point. k = 0, 1, 2, 3, 4 give 0, 1/2, 1/4, 3/4, 1/8.
/// Source: van der Corput, Proc. Akad. Wet. Amsterdam 38 (1935) 813-821.
double van_der_corput(std::uint64_t k);

/// "random-search": the start, then points uniform in the box until the evaluator refuses. It is
/// the baseline that any other solver should beat. It does not compare points itself, so it takes
/// any constraints.
Solver random_search();

/// A homotopy method: the solver solves the problem with a large smoothing parameter, then with
/// smaller ones, each from the previous result, until the problem is close to the true one. For
/// problems with a smoothing parameter. Named "continuation-" and the solver's name.
Solver continuation(Solver solver);

/// The capabilities of the continued solver, but without equalities; gradients and smoothing are
/// required.
Capabilities continuation_capabilities(const Capabilities& of);

}  // namespace ricochet
