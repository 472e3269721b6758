#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/regimes/border.h"

/// A border over a constant of the machine, by continuation.
namespace ricochet::carrier_track::inline regimes {

struct BorderPoint {
  double constant;  ///< in its own unit
  double omega;     ///< [rad/s], the border
  double slope;     ///< of the border over the constant, exact
};

/// The border at which a turn gets more collisions than on its slow side, because an impact passes
/// the counting limit, for machines with other values of one constant (see continuation_constants).
class BorderCurve {
 public:
  /// Throws InputError for an unknown constant, std::invalid_argument for a border of another kind
  /// or without more collisions beyond it.
  BorderCurve(const Border<SteadyMotion>& border, const std::string& constant);

  /// The point where the curve is now; at first the given border.
  const BorderPoint& here() const { return here_; }

  /// Follows the border to another value: a prediction along the slope, then Newton's method. Takes
  /// several steps if one is too long. Returns false, staying where it came to, if the border ends
  /// on the way.
  bool follow_to(double constant);

 private:
  std::optional<BorderPoint> solved(double constant, double omega, SteadyMotion& motion) const;

  std::string key_;
  int rank_;             // of the impact that passes the counting limit
  SteadyMotion motion_;  // at the border
  BorderPoint here_{};
};

}  // namespace ricochet::carrier_track::inline regimes
