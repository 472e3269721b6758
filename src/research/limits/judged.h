#pragma once

#include <string>
#include <vector>

#include "src/research/calibration/appraisal.h"
#include "src/research/limits/front_search.h"

/// Points that searches found by coarse cells, evaluated at evenly spaced speeds like every fit.
namespace ricochet::studies::limits {

struct Judged {
  Fit fit;
  GoalValues coarse;            ///< as in the search
  double claims;                ///< the sum of the loss over all claims, by coarse cells
  calibration::Appraisal fine;  ///< without its scans

  int counts_missed() const { return 10 - fine.exact_counts; }
  int examples_missed() const { return 20 - fine.right_examples; }
};

/// Its interpretation, its number of fitted parameters, and its evaluation.
void to_json(report::Json& json, const Judged& point);

/// In parallel, at speeds `step` [rad/s] apart.
std::vector<Judged> judged(const std::vector<Fit>& fits, double step);

/// Error of the coarse cells: largest differences, and how often the counts missed differ.
struct CoarseDoubt {
  int points = 0;
  double median_error = 0;   ///< |coarse - fine| of the thresholds' rms error
  double largest_error = 0;  ///< the same
  double largest_purity = 0;
  int other_counts = 0;    ///< points whose number of counts missed differs
  int other_examples = 0;  ///< the same of examples
};

CoarseDoubt doubt_of(const std::vector<Judged>& points);

/// Points worth evaluating: the points of the fronts that no other dominates in error, whole counts
/// missed, purity and examples, with limits on the examples missed and on the error.
struct Worth {
  int examples_missed;
  double error;
};
std::vector<Fit> worth_judging(const std::vector<const ChainedFront*>& fronts, const Worth& worth);

/// Pareto fronts of two numbers of the evaluated points, both to be minimised: the first rises, the
/// second falls.
using Pair = std::pair<double, double>;
std::vector<Pair> best_pairs(std::vector<Pair> pairs);

}  // namespace ricochet::studies::limits
