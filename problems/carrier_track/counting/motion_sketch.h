#pragma once

#include <vector>

#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline counting {

/// The parts of the motion at one speed on which a count depends: every impact that counts or
/// almost counts, every turning point near a wall, and their derivatives with respect to the speed.
class MotionSketch {
 public:
  /// `scene` must be valid for scan_completely(); omega [rad/s] > 0.
  MotionSketch(const Scene& scene, double omega);

  double omega() const { return omega_; }
  int count() const { return count_; }

  /// Returns true if, according to the derivatives at both speeds, no feature starts or stops to
  /// count between this speed and the faster one.
  bool joins(const MotionSketch& faster) const;

 private:
  /// A number and its derivative with respect to the speed [1/(rad/s)].
  struct Sloped {
    double value, slope;
  };
  enum class Kind { lower_impact, upper_impact, lower_graze, upper_graze };
  struct Feature {
    Kind kind;
    Sloped share;   ///< share of the window that has passed
    Sloped margin;  ///< of an impact: see collisions.h; of a graze: its distance / clearance
  };
  class Watch;

  static bool keeps_sign(const Sloped& a, const Sloped& b, double step);
  const Feature* counterpart(const Feature& feature, double step) const;
  bool joins_by_features_of(const MotionSketch& one, const MotionSketch& other,
                            bool forwards) const;

  double omega_;
  int count_ = 0;
  std::vector<Feature> features_;
};

}  // namespace ricochet::carrier_track::inline counting
