#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "src/report/json.h"
#include "src/research/calibration/appraisal.h"
#include "src/research/calibration/variant_search.h"

namespace ricochet::studies::calibration {

/// Length of the searches, and step of the evaluations.
struct VariantPlan {
  Search search;                     ///< of every variant, and of its baseline
  std::int64_t brief_evaluations;    ///< of those with short searches
  std::vector<int> seeds;            ///< of the searches
  double step;                       ///< [rad/s] between the speeds of an evaluation
  double brief_step;                 ///< [rad/s], of those with short searches
  std::vector<std::uint64_t> draws;  ///< seeds of random disturbances; the fit uses the first
};

/// About five minutes on two cores.
VariantPlan full_variant_plan(const Solver& global, const Solver& local);

/// The same in seconds, without convergence.
VariantPlan quick_variant_plan(const Solver& global, const Solver& local);

/// A model variant, its fit with each seed, and the evaluation of the best of them.
struct JudgedVariant {
  variants::ModelVariant variant;
  std::int64_t evaluations;
  std::vector<Fit> fits;  ///< one for each seed of the plan
  Appraisal appraisal;

  const Fit& best() const;
  double worst() const;
};

/// The thresholds for one draw of a random disturbance, with parameters fitted to another draw.
struct DrawnThresholds {
  std::uint64_t draw;
  double loss;
  std::vector<std::optional<double>> thresholds;  ///< [rad/s], of disturbed_cases
};

/// The cases with a disturbance other than 0 and a claimed threshold.
std::vector<carrier_track::Case> disturbed_cases();

/// The same parameters of compliant walls with three integrations: ode45 with default tolerances,
/// ode45 with tight ones, and exact events.
struct SameConstants {
  std::string fitted;  ///< the variant that they were fitted to
  double stiffness;    ///< [N/m^1.5]
  std::vector<CaseAppraisal> usual, tight, exact;
};

struct VariantResults {
  VariantPlan plan;
  std::vector<JudgedVariant> baselines;
  std::vector<JudgedVariant> variants;  ///< by rising loss of their best fits
  std::string drawn;                    ///< name of the variant of these draws
  std::vector<DrawnThresholds> draws;
  std::vector<SameConstants> integrations;

  /// Throws std::out_of_range for an unknown name.
  const JudgedVariant& variant(const std::string& name) const;

  /// The reference for a variant: the same base, with the same evaluations.
  const JudgedVariant& baseline_of(const JudgedVariant& variant) const;

  /// Returns true if every search of a variant ends below every search of its baseline.
  bool is_nearer(const JudgedVariant& variant) const;
};

/// Computes everything that is missing in the store. The results depend only on the plan, not on
/// the order of the fits.
VariantResults try_variants(const VariantPlan& plan, FitStore& store);

report::Json data_of(const VariantResults& results);

}  // namespace ricochet::studies::calibration
