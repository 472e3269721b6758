#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ricochet/problem.h"

namespace ricochet {

/// Makes a problem harder to solve without changing the problem itself: the solver sees perturbed
/// values, but is scored on the true objective. If coordinates change, box, start and best point
/// change with them.
struct Perturbation {
  std::string name;     ///< e.g. "noisy"
  std::string summary;  ///< its effect, in one line, with its constants
  /// Returns true if the problem can be perturbed this way.
  std::function<bool(const Problem&)> applies;
  /// The perturbed problem, of the same name, for ONE run with this seed. It counts its calls to
  /// draw independent numbers at each, so make one for every run, and use it in one thread.
  std::function<Problem(const Problem& shown, std::uint64_t seed)> perturbed;
};

/// All perturbations, first "plain", which changes nothing.
const std::vector<Perturbation>& all_perturbations();

/// The name for how a run shows its problem: that of the formulation and, unless it is "plain",
/// that of the perturbation. It enters the run's seed: see seed_of.
std::string shown_as(const std::string& formulation, const std::string& perturbation);

/// Stands between a solver and the functions of a problem, during one run. Each member evaluates
/// one of them at a solver's x and returns it unchanged unless it is overridden.
class PerturbedCalls {
 public:
  PerturbedCalls() = default;
  virtual ~PerturbedCalls() = default;
  PerturbedCalls(const PerturbedCalls&) = delete;
  PerturbedCalls& operator=(const PerturbedCalls&) = delete;

  virtual Values values(const Problem& shown, const Vector& x);
  virtual Derivatives derivatives(const Problem& shown, const Vector& x);
  virtual Residuals residuals(const Problem& shown, const Vector& x);
  virtual Matrix hessian(const Problem& shown, const Vector& x, double objective_factor,
                         const Vector& multipliers);

  /// Always the problem's own true values, whatever solvers are shown.
  virtual TrueValues true_values(const Problem& shown, const Vector& x);
};

/// The problem, and its surrogate at any smoothing parameter, with the perturbation. Problems with
/// the same perturbation object share its state. If the values shown are the true ones, they are
/// not computed a second time for scoring.
Problem perturbed_by(const std::shared_ptr<PerturbedCalls>& perturbation, const Problem& shown);

// Random numbers without a state: a draw depends on a key only, and a key on what it was made
// from, so that each call or point has its own draws. Uses the mixing function of SplitMix64
// (Steele, Lea and Flood, OOPSLA 2014, doi 10.1145/2660193.2660195; constants of Vigna's
// splitmix64.c), where a change of any bit of the key changes about half of the bits drawn.

/// A distinct key for every number, derived from a key.
std::uint64_t key_of(std::uint64_t key, std::uint64_t number);

/// The same for a name.
std::uint64_t key_of(std::uint64_t key, std::string_view name);

/// The same for a point, from all bits of all coordinates in their order; 0 and -0 are equal.
std::uint64_t key_of(std::uint64_t key, const Vector& point);

/// The draws of a key, one after the other: the sequence of SplitMix64.
class Draws {
 public:
  explicit Draws(std::uint64_t key) : state_(key) {}

  std::uint64_t bits();

  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform();

  /// Of mean 0 and standard deviation 1, from two uniform draws (Box and Muller, Annals of
  /// Mathematical Statistics 29 (1958) 610, doi 10.1214/aoms/1177706645).
  double normal();

  /// Standard Cauchy: half of the draws lie outside [-1, 1], and there is no mean.
  double cauchy();

 private:
  std::uint64_t state_;
};

/// The start is moved by a vector of random direction, uniform on the sphere, with length 1e-3
/// after scaling every side of the box to 1. A coordinate that would leave the box is moved the
/// other way, so that a start on the edge is moved too. If the problem has no start of its own, it
/// gets this one: every run begins near it, not anywhere in the box; only restarts of the solver
/// begin elsewhere.
Perturbation perturbed_start();

/// Every constraint is shown as 0 where it holds, to within constraint_tolerance, and as 1
/// elsewhere, where there is no number, too. Its slopes are 0, the derivative of that wherever it
/// has one; the Hessian of the Lagrangian is that of the objective. For problems with constraints.
Perturbation binary_constraints();

/// The objective is infinite where an inequality that is shown is broken, as of a simulation that
/// breaks down there: its gradient is NaN, all residuals infinite, their Jacobian NaN, and the
/// Hessian of a Lagrangian with an objective NaN. The constraints are shown as they are. Equalities
/// count for nothing here: they hold next to nowhere. For problems with inequalities. (Bounds can
/// be no such constraint: the evaluator asks no problem outside its box.)
Perturbation infinite_where_infeasible();

/// The variables, with their names, are permuted by a random cyclic permutation: no variable keeps
/// its place, and all such permutations are equally likely (Sattolo, Information Processing Letters
/// 22 (1986) 315, doi 10.1016/0020-0190(86)90073-6). For two variables or more.
Perturbation permuted();

/// Each variable is replaced by its negative with probability 1/2, and at least one is. The values
/// of the problem keep every bit.
Perturbation reflected();

/// The problem is rotated about its best point by a uniformly random orthogonal matrix. The box
/// stays the same, except that it grows if needed to contain the start; the variables are mixed now
/// and have no names. For problems that may be rotated, see Problem::rotates, with two variables or
/// more.
Perturbation rotated();

/// Every number v shown to the solver (values, gradient, Jacobian, residuals, Hessian) becomes v +
/// 1e-3 max(1, |v|) xi, with an independent standard normal xi at every call. So a gradient is the
/// true one plus independent noise, as from a noisy simulation that differentiates itself; it is
/// not the slope of the noise, which does not exist. Values that are not finite stay unchanged.
Perturbation noisy();

/// The same, but xi is a function of x: repeated evaluations do not average it away.
Perturbation frozen_noise();

/// With probability 0.2, fixed in x, a function is an outlier: its value v becomes v + max(1, |v|)
/// (pi/2) |C| with a standard Cauchy C, and every slope s of it s + max(1, |s|) (pi/2) C with an
/// independent C. All residuals together are one function. Probability and tail are those of the
/// Cauchy noise of COCO's bbob-noisy suite in its code (cocoex); there it is not scaled by |v|, but
/// here problems have values of any size.
Perturbation outliers();

/// Noise of BBOB's noisy functions (Hansen, Finck, Ros and Auger, INRIA RR-6869 (2009), "severe"),
/// independent at every call, on the gap g between the objective and the problem's best value,
/// unless g < 1e-8, where nothing changes; 1.01e-8 is added. Constraints are shown as they are,
/// residuals so that half their sum of squares is the objective shown; slopes take the factor. For
/// problems whose best value is known.
/// Gaussian: g becomes g exp(xi), xi standard normal.
Perturbation bbob_gaussian();

/// g becomes g u max(1, (1e9 / g)^((0.49 + 1/n) v)), u and v uniform in [0, 1), n variables.
Perturbation bbob_uniform();

/// g becomes g + max(0, 1000 + c), where c is standard Cauchy with probability 0.2, and 0 else.
Perturbation bbob_cauchy();

/// With probability 0.05, drawn independently at every call, a function fails: its value and all
/// its slopes are NaN. The objective and each constraint fail separately, all residuals together;
/// the Hessian of the Lagrangian fails in the same way.
Perturbation not_a_number();

/// With probability 1e-3 a call throws std::runtime_error, which ends the run: about one run in
/// three gets through 1000 calls. Points found before count.
Perturbation throwing();

/// Every call takes 0.1 ms of processor time, which counts against a budget in seconds (sleep would
/// not). The solver's results stay the same, unless it or its run has a time limit.
Perturbation slow();

/// Every number shown (values, gradient, Jacobian, residuals, Hessian) is rounded to 6 significant
/// digits, as in a printed table.
Perturbation truncated();

/// Everything is evaluated at the nearest point of a grid of 1001 values for every variable, from
/// the lower end of the box to the upper one, as on a machine whose controls have notches.
/// Derivatives are those of the unquantised functions at that point, not the zeros of a staircase.
/// The point that the solver evaluated is scored, not the grid point.
Perturbation quantised();

/// Whether a draw depends on the number of calls so far, or on x only, so that repeated evaluations
/// give the same result.
enum class Drawn { by_call, by_point };

/// Changes one function as shown: its values, and as many rows of slopes, or none if slopes were
/// not requested. Must draw for the values before it draws for the slopes.
using Tell =
    std::function<void(Eigen::Ref<Vector> values, Eigen::Ref<Matrix> slopes, Draws& draws)>;

/// The problem with everything it shows a solver changed by `tell`. Objective and gradient are
/// changed together, so are every constraint and its row of the Jacobian, and all residuals with
/// their Jacobian. The Hessian of the Lagrangian, whose multipliers change from call to call, is a
/// function without values; it stays symmetric. Each function has its own draws; its values are the
/// same whether its slopes are requested or not.
Problem told_by(const Tell& tell, Drawn drawn, std::uint64_t key, const Problem& shown);

}  // namespace ricochet
