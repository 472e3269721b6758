#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/research/calibration/fit.h"

namespace ricochet::studies::calibration {

/// Sensitivity of a case's thresholds to the parameters.
struct CaseSensitivity {
  std::string case_id;
  /// For each free parameter: d ln(threshold) / d ln(parameter), or per unit for a parameter whose
  /// bounds are not logarithmic (an angle: per radian; others: per width of the bounds). Nothing if
  /// a threshold is missing on either side.
  std::vector<std::optional<double>> slopes;
};

/// Central differences over 2 % of the parameter, or of the width of its bounds, with thresholds
/// from speeds `step` [rad/s] apart. C1..C10.
std::vector<CaseSensitivity> sensitivities(const Fit& fit, double step);

/// Profile of the loss over a parameter: how far it can move, in steps that double, before the
/// loss, with the other free parameters fitted again, has risen by one, i.e. by one tolerance of
/// one part of one case.
struct Profile {
  carrier_track::Unknown constant;
  double value;
  double lower, upper;          ///< the nearest values tried at which it has risen
  bool lower_open, upper_open;  ///< no value on that side reached it: the bound limits it
  std::vector<std::pair<double, double>> points;  ///< value and loss, by rising value
};

/// Returns the profile of every free parameter. `search.local` fits the others, with
/// search.evaluations at each point.
std::vector<Profile> profiles(const Fit& fit, const Search& search);

}  // namespace ricochet::studies::calibration
