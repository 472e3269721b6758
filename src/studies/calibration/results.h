#pragma once

#include <string>
#include <vector>

#include "src/report/json.h"
#include "src/studies/calibration/appraisal.h"
#include "src/studies/calibration/convergence.h"
#include "src/studies/calibration/fit_store.h"
#include "src/studies/calibration/sensitivity.h"

namespace ricochet::studies::calibration {

/// How long to search, and how closely to judge.
struct Plan {
  Search search;                                 ///< of each reading
  std::int64_t finalist_evaluations = 0;         ///< for each of the best readings, once more
  std::int64_t pin_evaluations = 0;              ///< for each try to hold one constant more
  std::int64_t left_out_evaluations = 0;         ///< for each fit without one case
  std::int64_t profile_evaluations = 0;          ///< at each point of a profile
  std::size_t fewest_constants = 2;              ///< where the frontier ends
  std::vector<Search> checks = {};               ///< that rank the readings once more
  double step = 0;                               ///< [rad/s] between the speeds of a judgement
  std::vector<carrier_track::Reading> readings;  ///< to be compared; of the best one the variations
                                                 ///< are compared too, if there are several, and
                                                 ///< then those of the best of these
  std::optional<ConvergencePlan> convergence = {};  ///< where one is asked for
};

/// All readings in some seven minutes on two cores.
Plan full_plan(const Search& search);

/// Three seeds by both of two solvers, for twelve readings: three quarters of an hour on two idle
/// cores.
ConvergencePlan full_convergence(const Solver& one, const Solver& other);

/// The same in seconds: nothing converges.
ConvergencePlan quick_convergence(const Solver& one, const Solver& other);

/// The same study in half a minute, for a first look: nothing converges.
Plan quick_plan(const Search& search);

struct RankedFit {
  Fit fit;
  Appraisal appraisal;
};

/// The threshold of a case, from a fit that has not seen the case.
struct Prediction {
  std::string case_id;
  double paper;                     ///< [rad/s]
  std::optional<double> predicted;  ///< [rad/s]
};

/// The misfits that another search finds for the same readings.
struct Ranking {
  Search search;
  std::vector<carrier_track::Reading> readings;  ///< of Results::readings, but the dearest
  std::vector<double> misfits;                   ///< one a reading
  double rank_correlation;  ///< Spearman's, with the misfits of Results::readings
};

struct Results {
  Plan plan;
  std::vector<RankedFit> readings;  ///< by rising misfit; the best by their closer fits
  std::vector<Ranking> rankings;
  /// Of the best readings whose cases share a scene the one with the lowest criterion, by falling
  /// number of fitted constants: each holds one more of them at its natural value, the one that
  /// costs least.
  std::vector<RankedFit> frontier;
  std::size_t chosen = 0;  ///< in the frontier: the one with the lowest criterion
  /// See long_searches().
  std::vector<Convergence> convergence;
  /// Of each of these the fits that are as good as the best, by rising criterion: the misfit, which
  /// looks at few speeds, does not tell them apart.
  std::vector<std::vector<RankedFit>> converged;
  RankedFit usual;  ///< the default reading, by today's misfit
  std::vector<Prediction> predictions;
  std::vector<CaseSensitivity> sensitivities;
  std::vector<Profile> profiles;

  /// The fit with the lowest criterion: of those that searches have converged to, where there are
  /// such, or else of the frontier.
  const RankedFit& choice() const;
};

/// Computes everything that the store does not hold yet. The same plan gives the same results, in
/// whatever order the fits are made.
Results calibrate(const Plan& plan, FitStore& store);

/// Root mean square of ln(predicted / paper); a missing prediction counts as ln 2.
double prediction_error(const std::vector<Prediction>& predictions);

report::Json data_of(const Results& results);

}  // namespace ricochet::studies::calibration
