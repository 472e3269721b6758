#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "src/report/results.h"
#include "src/studies/calibration/appraisal.h"
#include "src/studies/calibration/left_out.h"
#include "src/studies/calibration/searches.h"

namespace ricochet::studies::calibration {

/// Searches from random points, whose result must not depend on solver and seed.
struct LongSearches {
  std::vector<Solver> solvers;
  std::vector<int> seeds;
  std::int64_t evaluations = 0;  ///< of each search
  /// Of those that only rank interpretations; if they do not agree, they are as long as the others.
  std::int64_t brief_evaluations = 0;
  std::size_t interpretations = 0;  ///< number of the best, with the default free parameters
};

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
  /// To be compared. If there are several, the variations of the best one are compared too, and
  /// then those of the best of these.
  std::vector<carrier_track::Interpretation> interpretations = {};
  std::optional<LongSearches> long_searches = {};  ///< if requested
};

struct RankedFit {
  Fit fit;
  Appraisal appraisal;
};

/// The searches of a plan for the same parameters.
struct Convergence {
  std::int64_t evaluations = 0;  ///< of each search
  std::vector<Fit> fits;         ///< of each solver with each seed

  /// The fits within 1 % of the best loss.
  std::vector<Fit> as_good() const;
  bool agrees() const { return as_good().size() == fits.size(); }
};

struct Results {
  Plan plan;
  std::vector<RankedFit> interpretations;  ///< by rising loss; the best ones after refinement
  /// Starts with the best interpretation by criterion among those whose cases share a scene, by
  /// decreasing number of fitted parameters: each step fixes one more of them at its natural value,
  /// the one that increases the loss least.
  std::vector<RankedFit> frontier;
  std::size_t chosen = 0;  ///< index in the frontier: the one with the lowest criterion
  /// If requested, the searches for
  /// - the parameters chosen by the frontier,
  /// - those of the default interpretation, if they differ,
  /// - all parameters of the best interpretation whose cases share a scene,
  /// - and the best interpretations with the free parameters of the default one. One that equals a
  ///   better one to the last bit at the same parameters is left out: its differences have no
  ///   effect.
  std::vector<Convergence> convergence;
  /// For each of these the fits that are as good as the best, by rising criterion: the loss,
  /// evaluated at few speeds, does not separate them.
  std::vector<std::vector<RankedFit>> converged;
  RankedFit usual;  ///< the default interpretation, by the current loss
  std::vector<Prediction> predictions;
  std::vector<Profile> profiles;

  /// Returns the fit with the lowest criterion among the converged ones if there are any, else
  /// among the frontier.
  const RankedFit& choice() const;
};

/// Makes the runs that are not stored yet. The results depend only on the plan.
Results calibrate(const Plan& plan, Searches& searches);

/// What the page calibration.md is filled with.
report::Results findings_of(const Results& results);

}  // namespace ricochet::studies::calibration
