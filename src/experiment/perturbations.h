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

}  // namespace ricochet
