#pragma once

#include "problems/carrier_track/counting/counts.h"

namespace ricochet::studies::variants {

/// Thrown after the last impact that is needed.
using StoppedEarly = carrier_track::ImpactCount::Enough;

/// Ends a simulation with more impacts, counted or not, than a search needs: louder than anything
/// in the paper.
class ImpactLimit {
 public:
  static constexpr int most = 20000;

  void pass() {
    if (++heard_ > most) throw StoppedEarly();
  }

 private:
  int heard_ = 0;
};

}  // namespace ricochet::studies::variants
