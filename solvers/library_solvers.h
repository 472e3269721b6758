#pragma once

#include <cstdint>
#include <vector>

#include "ricochet/solver.h"
#include "solvers/adjustable_solver.h"

namespace ricochet {

/// "dlib-global-search": dlib's search without parameters in the unit cube, or in other
/// "coordinates". It alternates between
/// the highest point of an upper bound, LIPO (Malherbe and Vayatis, ICML 2017, 2314-2323), and a
/// step to the optimum of a quadratic model in a trust region. It begins with the start and points
/// uniform in the box, until two values differ. Points without a finite value count as the worst so
/// far.
///
/// The time for a point grows in proportion to the number of points before it, and with the number
/// of variables. So the solver takes at most 8 variables, ends after 400 points, and looks for the
/// highest point of the bound among 1000 points instead of 5000: 1000 evaluations take about a
/// second.
Solver dlib_global_search();
inline constexpr Capabilities dlib_capabilities = {.most_variables = 8};
AdjustableSolver adjustable_dlib();

/// "ipopt": the interior-point method of Waechter and Biegler (Math. Program. 106 (2006) 25-57) in
/// the problem's own coordinates, with a limited-memory Hessian. Ipopt is not thread-safe, so a
/// process runs one solve at a time and others wait; waiting takes no processor time.
Solver ipopt(Settings settings);
inline constexpr Capabilities ipopt_capabilities = {.constraints = Capabilities::Constraints::all,
                                                    .derivatives = Capabilities::Order::gradient};

/// "ipopt-exact": the same with its own settings and the exact Hessian of the Lagrangian.
Solver ipopt_exact();
inline constexpr Capabilities ipopt_exact_capabilities = {
    .constraints = Capabilities::Constraints::all, .derivatives = Capabilities::Order::hessian};

/// "ipopt", "ipopt-tuned" and "ipopt-exact" with any of Ipopt's own options under its names, and
/// "coordinates", except those that choose the Hessian, write files, or end a run by the clock.
std::vector<AdjustableSolver> adjustable_ipopt();

/// "ceres-lbfgs": the limited-memory BFGS line search of Ceres. It takes no bounds, so it works on
/// y in R^n with x = middle + half width * sin(angle), where the angle is y / half width: in the
/// middle of the box dx / dy = 1. On a bound it is 0, so a start there is moved inside by 5e-4 of
/// the box.
Solver ceres_lbfgs();
inline constexpr Capabilities ceres_lbfgs_capabilities = {.derivatives =
                                                              Capabilities::Order::gradient};

/// With Ceres's own options "max_lbfgs_rank", "function_tolerance", "gradient_tolerance",
/// "parameter_tolerance", "line_search_sufficient_function_decrease",
/// "line_search_sufficient_curvature_decrease", and "coordinates".
AdjustableSolver adjustable_ceres_lbfgs();

/// "ceres-trust-region": the Levenberg-Marquardt method of Ceres in the unit cube,
/// with dense QR decomposition, in one thread. Ends at once if the residuals at the start are not
/// finite. Ceres projects its steps onto the box and can stop short of an optimum on a bound:
/// https://github.com/ceres-solver/ceres-solver/issues/187.
Solver ceres_least_squares();
inline constexpr Capabilities ceres_least_squares_capabilities = {.needs_residuals = true};

/// With Ceres's own options "initial_trust_region_radius", "function_tolerance" and
/// "parameter_tolerance", and "coordinates".
AdjustableSolver adjustable_ceres_least_squares();

/// Solvers of TAO, the optimisation part of PETSc, each with its library's own settings, in the
/// problem's own coordinates, POUNDERS in the unit cube; "coordinates" is their option: bounded
/// limited-memory variable metric, `tao-blmvm`; bounded quasi-Newton line search, `tao-bqnls`;
/// bounded nonlinear conjugate gradients, `tao-bncg`; for least squares POUNDERS, without
/// derivatives, `tao-pounders`, and bounded regularised Gauss-Newton, `tao-brgn`. Sources: for
/// POUNDERS, Wild, in Advances and Trends in Optimization with Engineering Applications (2017), ch.
/// 40; for all, the TAO Users Manual, ANL/MCS-TM-322 Rev. 3.18 (2022).
///
/// They are in a separate shared library, which the first start of one loads, in 0.1 s; a start
/// throws std::runtime_error if it does not load. Returns none if that library or PETSc is missing.
std::vector<Solver> tao_solvers();
std::vector<AdjustableSolver> adjustable_tao();
inline constexpr Capabilities tao_gradient_capabilities = {.derivatives =
                                                               Capabilities::Order::gradient};
inline constexpr Capabilities tao_residual_capabilities = {.needs_residuals = true};

/// Solvers of SciPy (Virtanen et al., Nature Methods 17 (2020) 261-272; doi
/// 10.1038/s41592-019-0686-2), in the problem's own coordinates with SciPy's own settings. Those
/// that take gradients are given exact ones, at the points where SciPy asks for them. A number that
/// is not finite counts as infinite.
struct ScipySolver {
  const char* name;
  Capabilities capabilities;
  bool stochastic;
};
inline constexpr ScipySolver scipy_list[] = {
    // Kraft, DFVLR-FB 88-28 (1988).
    {"scipy-slsqp",
     {.constraints = Capabilities::Constraints::all, .derivatives = Capabilities::Order::gradient},
     false},
    // Zhu, Byrd, Lu and Nocedal, ACM Trans. Math. Softw. 23 (1997) 550-560.
    {"scipy-l-bfgs-b", {.derivatives = Capabilities::Order::gradient}, false},
    // Xiang, Sun, Fan and Gong, Phys. Lett. A 233 (1997) 216-220, with L-BFGS-B by differences.
    {"scipy-dual-annealing", {}, true},
    // Storn and Price, J. Global Optim. 11 (1997) 341-359; constraints by Lampinen, CEC 2002.
    {"scipy-differential-evolution", {.constraints = Capabilities::Constraints::all}, true}};

/// Those of scipy_list, served by a program in Python; none if it, or the SciPy that ricochet was
/// configured with, is missing. Copies of one program serve all threads of all processes that run
/// solvers. A run fails, with std::runtime_error, if that program ends or has another SciPy.
std::vector<Solver> scipy_solvers();

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
