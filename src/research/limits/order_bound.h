#pragma once

#include <cstddef>
#include <vector>

#include "problems/carrier_track/paper/cases.h"

/// How near a model can come to the paper's thresholds whose own thresholds are ordered as the
/// paper concludes: bounds that hold whatever the model's equations and constants are.
namespace ricochet::studies::limits {

/// One value must not be greater than another; both by their place.
struct AtMost {
  std::size_t lower, upper;
};

/// What is lost by being ordered.
struct OrderBound {
  double root_mean_square;      ///< least of all ordered values' distance from the given ones
  double largest;               ///< least largest distance; of other ordered values, in general
  std::vector<double> nearest;  ///< the ordered values of the least mean square
};

/// Isotonic regression over a partial order, in closed form: the nearest value at i is the largest,
/// over upper sets U with i, of the smallest, over lower sets L with i, mean of U and L (Robertson,
/// Wright and Dykstra, Order Restricted Statistical Inference, 1988, theorem 1.4.4); the least
/// largest distance is half the largest violation. At most 16 values.
OrderBound isotonic_bound(const std::vector<double>& values, const std::vector<AtMost>& order);

/// What the paper concludes of thresholds, between cases by their place in the list: without
/// disturbance they fall with the recovery coefficient (A) and do not with friction (B); they fall
/// with the disturbance, whatever the rest is (C). Between cases that differ in nothing else.
std::vector<AtMost> concluded_order(const std::vector<carrier_track::Case>& cases);

/// That thresholds do not depend on the disturbance at all: for cases that differ in nothing else,
/// both ways.
std::vector<AtMost> indifferent_order(const std::vector<carrier_track::Case>& cases);

/// A machine of the paper at three disturbances.
struct Response {
  std::vector<carrier_track::Case> cases;  ///< by rising disturbance: 0, 0.1 and 1 N
  double first_share;                      ///< of the whole fall of ln(threshold) that comes first
  /// By how much ln(threshold) at the middle disturbance lies below the chord.
  double below_chord;
};

/// Those of which the paper tells three thresholds.
std::vector<Response> responses(const std::vector<carrier_track::Case>& cases);

/// The same for models whose thresholds fall in proportion to the disturbance, as the first order
/// of any smooth dependence does, or by more and more: ln(threshold) is linear or concave. A chord
/// must not lie above the value in the middle; all else is as the paper has it.
OrderBound proportional_bound(const std::vector<Response>& responses, std::size_t thresholds);

/// The cases of which the paper tells a threshold, and the logarithms of these.
std::vector<carrier_track::Case> cases_with_threshold();
std::vector<double> log_thresholds(const std::vector<carrier_track::Case>& cases);

}  // namespace ricochet::studies::limits
