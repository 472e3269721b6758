#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/studies/calibration/fit.h"

namespace ricochet::studies::calibration {

/// How the thresholds of a case answer to the constants.
struct CaseSensitivity {
  std::string case_id;
  /// One a freed constant: d ln(threshold) / d ln(constant), and per unit for a constant whose
  /// bounds are not logarithmic (an angle: per radian; others: per width of the bounds). None
  /// where a threshold is missing on either side.
  std::vector<std::optional<double>> slopes;
};

/// Central differences over 2 % of the constant, or of the width of its bounds, with thresholds
/// from speeds `step` [rad/s] apart. C1..C10.
std::vector<CaseSensitivity> sensitivities(const Fit& fit, double step);

/// How far a constant may go, in steps that double, before the misfit, with the other freed
/// constants fitted anew, has risen by one: by one tolerance of one part of one case.
struct Profile {
  carrier_track::Open constant;
  double value;
  double lower, upper;          ///< the nearest values tried at which it has
  bool lower_open, upper_open;  ///< nothing tried on that side has: the bounds end it
  std::vector<std::pair<double, double>> points;  ///< value and misfit, by rising value
};

/// The profile of every freed constant. `search.local` fits the others, with search.evaluations
/// at each point.
std::vector<Profile> profiles(const Fit& fit, const Search& search);

}  // namespace ricochet::studies::calibration
