#pragma once

#include <cstddef>
#include <vector>

#include "problems/carrier_track/suite/machine.h"

/// Lower bounds on the error of a model's thresholds if they are ordered as the paper concludes:
/// valid for any equations and parameters of the model.
namespace ricochet::studies::reproduction {

/// One value must not be greater than another; both by index.
struct AtMost {
  std::size_t lower, upper;
};

/// Distance between the given values and the nearest values that satisfy the order constraints.
struct OrderBound {
  double root_mean_square;      ///< least root mean square distance of ordered values
  double largest;               ///< least largest distance; generally of other ordered values
  std::vector<double> nearest;  ///< the ordered values of the least mean square
};

/// Isotonic regression over a partial order, in closed form: the nearest value at i is the maximum,
/// over upper sets U with i, of the minimum, over lower sets L with i, of the mean of the
/// intersection of U and L (Robertson, Wright and Dykstra, Order Restricted Statistical Inference,
/// 1988, theorem 1.4.4); the least largest distance is half the largest violation. At most 16
/// values.
OrderBound isotonic_bound(const std::vector<double>& values, const std::vector<AtMost>& order);

/// The paper's conclusions on thresholds, between cases by index: without disturbance they fall
/// with the recovery coefficient (A) and do not fall with friction (B); they fall with the
/// disturbance, whatever the other values are (C). Only between cases that differ in nothing else.
std::vector<AtMost> concluded_order(const std::vector<carrier_track::Case>& cases);

/// The constraint that thresholds do not depend on the disturbance: both directions, for cases that
/// differ in nothing else.
std::vector<AtMost> indifferent_order(const std::vector<carrier_track::Case>& cases);

/// A machine of the paper at three disturbances.
struct Response {
  std::vector<carrier_track::Case> cases;  ///< by rising disturbance: 0, 0.1 and 1 N
  double first_share;                      ///< share of the fall of ln(threshold) in the first step
  /// Returns how far ln(threshold) at the middle disturbance lies below the chord.
  double below_chord;
};

/// The machines for which the paper gives three thresholds.
std::vector<Response> responses(const std::vector<carrier_track::Case>& cases);

/// The same bound for models whose thresholds fall in proportion to the disturbance, as the first
/// order of any smooth dependence does, or faster: ln(threshold) is linear or concave. The chord
/// must not lie above the value in the middle; everything else is as in the paper.
OrderBound proportional_bound(const std::vector<Response>& responses, std::size_t thresholds);

/// The cases for which the paper gives a threshold, and the logarithms of these.
std::vector<carrier_track::Case> cases_with_threshold();
std::vector<double> log_thresholds(const std::vector<carrier_track::Case>& cases);

}  // namespace ricochet::studies::reproduction
