#pragma once

#include <string>
#include <vector>

#include "src/studies/calibration/appraisal.h"
#include "src/studies/calibration/convergence.h"
#include "src/studies/calibration/fit.h"
#include "src/studies/calibration/left_out.h"

namespace ricochet::studies::calibration {

/// Length of the searches, and step of the evaluations.
struct Plan {
  Search search;                          ///< of each interpretation
  std::int64_t finalist_evaluations = 0;  ///< for each of the best interpretations, in addition
  std::int64_t pin_evaluations = 0;       ///< for each attempt to fix one more parameter
  std::int64_t left_out_evaluations = 0;  ///< of each search without some cases
  int left_out_searches = 1;              ///< for each group of cases that is left out
  std::int64_t profile_evaluations = 0;   ///< at each point of a profile
  std::size_t fewest_constants = 2;       ///< where the frontier ends
  double step = 0;                        ///< [rad/s] between the speeds of an evaluation
  std::vector<carrier_track::Interpretation>
      interpretations;  ///< to be compared; of the best one the variations
                        ///< are compared too, if there are several, and
                        ///< then those of the best of these
  std::optional<ConvergencePlan> convergence = {};  ///< if requested
};

/// All interpretations; about seven minutes on two cores.
Plan full_plan(const Search& search);

/// Three seeds and two solvers for twelve interpretations; 45 minutes on two idle cores.
ConvergencePlan full_convergence(const Solver& one, const Solver& other);

/// The same in seconds, without convergence.
ConvergencePlan quick_convergence(const Solver& one, const Solver& other);

/// The same study in half a minute, for a first look, without convergence.
Plan quick_plan(const Search& search);

struct RankedFit {
  Fit fit;
  Appraisal appraisal;
};

struct Results {
  Plan plan;
  std::vector<RankedFit> interpretations;  ///< by rising loss; the best ones after refinement
  /// Starts with the best interpretation by criterion among those whose cases share a scene, by
  /// decreasing number of fitted parameters: each step fixes one more of them at its natural value,
  /// the one that increases the loss least.
  std::vector<RankedFit> frontier;
  std::size_t chosen = 0;  ///< index in the frontier: the one with the lowest criterion
  /// See long_searches().
  std::vector<Convergence> convergence;
  /// For each of these the fits that are as good as the best, by rising criterion: the loss,
  /// evaluated at few speeds, does not separate them.
  std::vector<std::vector<RankedFit>> converged;
  RankedFit usual;  ///< the default interpretation, by the current loss
  std::vector<Prediction> predictions;
  std::vector<CaseSensitivity> sensitivities;
  std::vector<Profile> profiles;

  /// Returns the fit with the lowest criterion among the converged ones if there are any, else
  /// among the frontier.
  const RankedFit& choice() const;
};

/// Computes everything that is missing in the store. The results depend only on the plan, not on
/// the order of the fits.
Results calibrate(const Plan& plan, FitStore& store);

/// Runs the searches of Plan::convergence for
/// - the parameters chosen by the frontier,
/// - those of the default interpretation, if they differ,
/// - all parameters of the best interpretation whose cases share a scene,
/// - and, for fewer evaluations, the best interpretations with the free parameters of the default
///   one, including it.
/// An interpretation is left out if it equals a better one to the last bit at the same parameters:
/// its differences then have no effect.
std::vector<Convergence> long_searches(const Results& results, FitStore& store);

}  // namespace ricochet::studies::calibration
