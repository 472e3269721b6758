#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/counting/threshold.h"
#include "src/studies/calibration/fit.h"

namespace ricochet::studies::calibration {

/// The collision count of a case at a speed, by a reading and its constants. Refers to both.
carrier_track::CountAt counts_of(const carrier_track::Case& a_case,
                                 const carrier_track::Reading& reading,
                                 const carrier_track::Constants& constants);

/// Those counts at evenly spaced speeds up to 18 rad/s, side by side where the reading allows it.
carrier_track::SpeedScan scan_of(const carrier_track::Case& a_case,
                                 const carrier_track::Reading& reading,
                                 const carrier_track::Constants& constants, double step);

/// A case, judged: the six parts of its score over evenly spaced speeds.
struct CaseAppraisal {
  carrier_track::Case the_case;
  carrier_track::SpeedScan scan;
  carrier_track::Score score;
};

/// What a fit is worth, over all cases, in the terms of the paper.
struct Appraisal {
  std::vector<CaseAppraisal> cases;  ///< C1..C12
  double threshold_error = 0;        ///< root mean square of ln(threshold / paper)
  double worst_threshold = 0;        ///< largest |ln|
  int within = 0;                    ///< thresholds within 5 % of the paper's
  int exact_counts = 0;              ///< quiet counts that equal the paper's
  double purity = 1;                 ///< lowest of C1..C10
  double misclassified = 0;          ///< highest of C1..C10
  double loudness = 0;               ///< lowest of C1..C10
  int right_examples = 0;            ///< of 20
  double quiet_share = 0;            ///< of the speeds at which C11 is quiet as C4 is, in [0, 1]
  double criterion = 0;              ///< AICc, see below
};

/// Judges at speeds `step` [rad/s] apart, up to 18 rad/s.
///
/// The criterion weighs the error against the number of fitted constants k (Hurvich and Tsai 1989,
/// doi:10.1093/biomet/76.2.297): with the n = 20 errors ln(threshold / paper) and
/// ln(quiet count / paper), n ln(mean square) + 2 p + 2 p (p + 1) / (n - p - 1), p = k + 1. Lower
/// is better; from k = 18 on it is infinite: such a fit has memorised.
Appraisal appraise(const Fit& fit, double step);

/// The same of C1..C12, judged already, whatever has counted; with so many constants fitted.
Appraisal summed_up(std::vector<CaseAppraisal> cases, int constants);

/// The criterion alone. Mean squares below 1e-6 count as that: no count or threshold of the paper
/// has more digits.
double selection_criterion(double sum_of_squares, int errors, int constants);

}  // namespace ricochet::studies::calibration
