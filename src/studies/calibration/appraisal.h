#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/counting/threshold.h"
#include "ricochet/machine.h"
#include "src/report/json.h"
#include "src/studies/calibration/searches.h"

namespace ricochet::studies::calibration {

/// The evaluation of a case: the six parts of its score over evenly spaced speeds.
struct CaseAppraisal {
  carrier_track::Case the_case;
  carrier_track::SpeedScan scan;
  carrier_track::Score score;
};

/// At speeds `step` [rad/s] apart, up to 18 rad/s, vectorised if the interpretation allows it.
CaseAppraisal appraise(const carrier_track::Parameterisation& fit,
                       const carrier_track::Case& a_case, double step);

/// The evaluation of a fit over all cases, in the terms of the paper.
struct Appraisal {
  std::vector<CaseAppraisal> cases;  ///< C1..C12
  double threshold_error = 0;        ///< root mean square of ln(threshold / paper)
  int within = 0;                    ///< thresholds within 5 % of the paper's
  int exact_counts = 0;              ///< quiet counts that equal the paper's
  double purity = 1;                 ///< lowest of C1..C10
  double misclassified = 0;          ///< highest of C1..C10
  double loudness = 0;               ///< lowest of C1..C10
  int right_examples = 0;            ///< of 20
  double quiet_share = 0;            ///< speeds at which C11 is as quiet as C4, share in [0, 1]
  double criterion = 0;              ///< AICc, see below
};

RICOCHET_FIELDS(Appraisal, threshold_error, within, exact_counts, purity, misclassified, loudness,
                right_examples, quiet_share, criterion);

/// The same of all cases, in parallel.
///
/// The criterion weighs the error against the number of fitted parameters k (Hurvich and Tsai 1989,
/// doi:10.1093/biomet/76.2.297): with the n = 20 errors ln(threshold / paper) and ln(quiet count /
/// paper), n ln(mean square) + 2 p + 2 p (p + 1) / (n - p - 1), p = k + 1. Lower is better; from k
/// = 18 on it is infinite: such a fit is overfitted.
Appraisal appraise(const carrier_track::Parameterisation& fit, double step);

/// The criterion alone. A mean square below 1e-6 counts as 1e-6: no count or threshold of the paper
/// has more digits.
double selection_criterion(double sum_of_squares, int errors, int constants);

/// Profile of the loss over a parameter: how far it can move, in steps that double, before the
/// loss, with the other free parameters fitted again, has risen by one, i.e. by one tolerance of
/// one part of one case.
struct Profile {
  carrier_track::Unknown constant;
  double value;
  double lower, upper;          ///< the nearest values tried at which it has risen
  bool lower_open, upper_open;  ///< no value on that side reached it: the bound limits it

  bool is_determined() const { return !lower_open && !upper_open; }
};

/// Returns the profile of every free parameter. The local solvers fit the others, with
/// search.evaluations at each point.
std::vector<Profile> profiles(const Fit& fit, const Search& search, Searches& searches);

}  // namespace ricochet::studies::calibration
