#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/benchmark/statistics/interval.h"
#include "src/report/json.h"
#include "src/research/long_run/border_fit.h"
#include "src/research/long_run/border_law.h"
#include "src/research/long_run/count_fit.h"

/// What the thresholds of the paper are in the long run.
namespace ricochet::studies::long_run {

struct Plan {
  CountPlan counts;
  BorderPlan borders;
  calibration::Search left_out;  ///< of the default interpretation, for each case left out
  std::vector<double> restitutions, frictions;  ///< of the law's machines
};

/// Some minutes on two idle cores.
Plan full_plan();

/// The same in half a minute: nothing converges.
Plan quick_plan();

/// The default interpretation, judged like the others.
struct UsualFit {
  calibration::Fit fit;
  calibration::Appraisal appraisal;
  std::vector<double> left_out;  ///< as of a CountFit
};

struct Results {
  Plan plan;
  UsualFit usual;
  std::vector<CountFit> counts;
  std::vector<BorderFit> borders;
  LawComparison law;
};

Results long_run(const Plan& plan);

/// The root mean square of errors, and its 95 % interval from samples of the cases drawn with
/// replacement (percentile bootstrap). Deterministic.
struct RootMeanSquare {
  double value;
  Interval interval;
};
RootMeanSquare root_mean_square(const std::vector<double>& errors);

report::Json data_of(const Results& results);

}  // namespace ricochet::studies::long_run
