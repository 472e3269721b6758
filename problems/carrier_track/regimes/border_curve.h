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
  double slope;     ///< of the border over the constant, see BorderCurve
};

/// Why a curve goes no farther.
enum class CurveEnd {
  range,           ///< it reaches the value asked for
  fold_back,       ///< it turns back: no such border beyond
  other_border,    ///< the motion itself changes: another border ends this one
  impact_missing,  ///< the impact that passes the counting limit is no longer there
  speeds,          ///< it leaves the range of speeds
  not_sharp,       ///< such a border is not followed: beside a motion that does not repeat
  not_found        ///< the border is not found beyond, for none of these reasons
};

/// The name as it stands in JSON: "fold-back".
std::string name_of(CurveEnd end);

/// A border for machines with other values of one constant (see continuation_constants).
///
/// Where an impact passes the counting limit, and where the forces start to beat friction, a point
/// is the solution of one equation by Newton's method, and its slope is exact. A border of another
/// kind is solved again near where it is expected, and its slope is a central difference, right to
/// some 1e-6 of itself.
class BorderCurve {
 public:
  /// Throws InputError for an unknown constant, std::invalid_argument if there is no such border.
  BorderCurve(const Border& border, const std::string& constant);

  /// The point where the curve is now; at first the given border.
  const BorderPoint& here() const { return here_; }

  /// Follows the border to another value: a prediction along the slope, then Newton's method. Takes
  /// several steps if one is too long. Returns false, staying where it came to, if the border ends
  /// on the way; end() says why.
  bool follow_to(double constant);

  CurveEnd end() const { return end_; }

 private:
  std::optional<BorderPoint> solved(double constant, double omega, SteadyMotion& motion);
  std::optional<BorderPoint> limit_passed(double constant, double omega, SteadyMotion& motion);
  std::optional<BorderPoint> released(double constant, double omega, SteadyMotion& motion);
  std::optional<BorderPoint> solved_again(double constant, double omega, SteadyMotion& motion);
  std::optional<double> border_near(double constant, double omega, SteadyMotion& motion);
  Scene machine_at(double constant) const;

  std::string key_;
  RegimeEnd kind_;
  Signature before_, after_;
  int rank_;             // of the impact that passes the counting limit
  double onward_;        // 1 or -1: where the speed leads over the border
  SteadyMotion motion_;  // at the border, on its nearer side
  BorderPoint here_{};
  CurveEnd end_ = CurveEnd::range;
};

/// The border between two regimes that follow each other, of a machine without disturbance.
Border border_between(const Regime& slower, const Regime& faster);

}  // namespace ricochet::carrier_track::inline regimes
