#pragma once

#include "problems/carrier_track/counting/collisions.h"
#include "ricochet/recording.h"
#include "ricochet/scene.h"
#include "src/research/calibration/variants/early_stopping.h"
#include "src/research/calibration/variants/motion_change.h"

namespace ricochet::studies::variants {

/// Both limits of equation (33) on the heights: impacts on the outer wall and maxima count from
/// `high` on, impacts on the inner wall and minima up to `low`, with the inner wall at
/// `inner_wall`. An impact counts only above the scene's counting limit, and a velocity zero
/// between the walls only if the impact before it was that fast: chattering would count without
/// end.
class HeightCount : public VariantObserver {
 public:
  /// [m], relative to an inner wall at `inner_wall` instead of 0.
  struct Limits {
    double inner_wall, high, low;
  };

  HeightCount(const carrier_track::Scene& scene, const Limits& limits, int most)
      : scene_(scene), limits_(limits), most_(most) {}

  void impact(double /*time*/, carrier_track::Wall wall, double speed) {
    limit_.pass();
    was_fast_ = carrier_track::is_counted(speed, scene_.counting_limit);
    if (!was_fast_) return;
    if (wall == carrier_track::Wall::upper && is_high(scene_.wall_upper)) add();
    if (wall == carrier_track::Wall::lower && is_low(scene_.wall_lower)) add();
  }

  void peak(double /*time*/, double position) {
    if (was_fast_ && position < scene_.wall_upper && is_high(position)) add();
  }

  void valley(double /*time*/, double position) {
    if (was_fast_ && position > scene_.wall_lower && is_low(position)) add();
  }

  int count() const { return count_; }

 private:
  double height(double position) const { return limits_.inner_wall + position - scene_.wall_lower; }
  bool is_high(double position) const { return height(position) >= limits_.high; }
  bool is_low(double position) const { return height(position) <= limits_.low; }
  void add() {
    if (++count_ > most_) throw StoppedEarly();
  }

  const carrier_track::Scene& scene_;
  Limits limits_;
  int most_;
  ImpactLimit limit_;
  bool was_fast_ = true;
  int count_ = 0;
};

}  // namespace ricochet::studies::variants
