#pragma once

#include "problems/carrier_track/scene/scene.h"
#include "src/studies/trials/most_impacts.h"
#include "src/studies/trials/what_if.h"

namespace ricochet::studies::trials {

/// Both limits of equation (33) on the heights of what the carrier does: hits on the outer wall and
/// maxima count from `high` on, hits on the inner wall and minima up to `low`, with the inner wall
/// at `inner_wall`. A hit counts only if it is faster than the scene's slowest, and a turn between
/// the walls unless the hit before it was slower than that: small hops would count without end.
class HeightCount : public WhatIfObserver {
 public:
  /// [m], of x where the inner wall is not at 0 but at `inner_wall`.
  struct Limits {
    double inner_wall, high, low;
  };

  HeightCount(const carrier_track::Scene& scene, const Limits& limits, int most)
      : scene_(scene), limits_(limits), most_(most) {}

  void impact(double /*time*/, carrier_track::Wall wall, double speed) {
    limit_.pass();
    was_fast_ = carrier_track::is_counted(speed, scene_.slowest);
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
    if (++count_ > most_) throw Enough();
  }

  const carrier_track::Scene& scene_;
  Limits limits_;
  int most_;
  MostImpacts limit_;
  bool was_fast_ = true;
  int count_ = 0;
};

}  // namespace ricochet::studies::trials
