#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "src/report/json.h"
#include "src/studies/trials/fit_store.h"
#include "src/studies/trials/judgement.h"

namespace ricochet::studies::trials {

/// How long to search, and how closely to judge.
struct TrialPlan {
  TrialSearch search;                ///< of every trial, and of what it is measured by
  std::int64_t brief_evaluations;    ///< of those that are searched briefly
  std::vector<int> seeds;            ///< of the searches
  double step;                       ///< [rad/s] between the speeds of a judgement
  double brief_step;                 ///< [rad/s], of those that are searched briefly
  std::vector<std::uint64_t> draws;  ///< seeds of random disturbances; the first is fitted
};

/// In some ten minutes on two cores.
TrialPlan full_trial_plan(const Solver& global, const Solver& local);

/// The same in seconds: no search ends.
TrialPlan quick_trial_plan(const Solver& global, const Solver& local);

/// A trial, its fit from each seed, and what the best of them is worth.
struct JudgedTrial {
  Trial trial;
  std::int64_t evaluations;
  std::vector<TrialFit> fits;  ///< one a seed of the plan
  calibration::Appraisal appraisal;

  const TrialFit& best() const;
  double worst() const;
};

/// The thresholds that one draw of a random disturbance makes, by constants fitted to another.
struct DrawnThresholds {
  std::uint64_t draw;
  double misfit;
  std::vector<std::optional<double>> thresholds;  ///< [rad/s], of disturbed_cases
};

/// The cases whose disturbance is not 0 and whose threshold is claimed.
std::vector<carrier_track::Case> disturbed_cases();

/// The same constants of compliant walls three ways: at the default tolerances of ode45, at tight
/// ones, and with exact events.
struct SameConstants {
  std::string fitted;  ///< the trial that they were fitted to
  TrialConstants constants;
  std::vector<calibration::CaseAppraisal> usual, tight, exact;
};

struct Results {
  TrialPlan plan;
  std::vector<JudgedTrial> baselines;
  std::vector<JudgedTrial> trials;
  std::string drawn;  ///< the trial whose draws these are
  std::vector<DrawnThresholds> draws;
  std::vector<SameConstants> integrations;

  /// Throws std::out_of_range for a name that none has.
  const JudgedTrial& trial(const std::string& name) const;

  /// What a trial is measured by: the same base, searched as long.
  const JudgedTrial& baseline_of(const JudgedTrial& trial) const;

  /// Whether every search of a trial ends below every search of its baseline.
  bool is_nearer(const JudgedTrial& trial) const;
};

/// Computes everything that the store does not hold yet. The same plan gives the same results, in
/// whatever order the fits are made.
Results try_all(const TrialPlan& plan, TrialFitStore& store);

report::Json data_of(const Results& results);

}  // namespace ricochet::studies::trials
