#pragma once

#include <string>
#include <vector>

#include "src/studies/calibration/appraisal.h"
#include "src/studies/limits/front_search.h"

/// Points that searches found by coarse cells, judged at evenly spaced speeds as every fit is.
namespace ricochet::studies::limits {

struct Judged {
  Fit fit;
  GoalValues coarse;            ///< as the search saw it
  double claims;                ///< the sum of the misfit over all claims, by coarse cells
  calibration::Appraisal fine;  ///< without its scans

  int counts_missed() const { return 10 - fine.exact_counts; }
  int examples_missed() const { return 20 - fine.right_examples; }
};

/// In parallel, at speeds `step` [rad/s] apart.
std::vector<Judged> judged(const std::vector<Fit>& fits, double step);

/// How far coarse cells are off: largest differences, and how often the counts missed differ.
struct CoarseDoubt {
  int points = 0;
  double median_error = 0;   ///< |coarse - fine| of the thresholds' rms error
  double largest_error = 0;  ///< the same
  double largest_purity = 0;
  int other_counts = 0;    ///< points with another number of counts missed
  int other_examples = 0;  ///< the same of examples
};

CoarseDoubt doubt_of(const std::vector<Judged>& points);

/// Points worth judging: of the fronts' points those that no other is as good as in error, whole
/// counts missed, purity and examples, with at most so many examples missed and such an error.
struct Worth {
  int examples_missed;
  double error;
};
std::vector<Fit> worth_judging(const std::vector<const ChainedFront*>& fronts, const Worth& worth);

/// Best pairs of two numbers of the judged, both lower for better: by rising first, falling second.
using Pair = std::pair<double, double>;
std::vector<Pair> best_pairs(std::vector<Pair> pairs);

}  // namespace ricochet::studies::limits
