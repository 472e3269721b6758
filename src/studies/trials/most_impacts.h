#pragma once

#include "problems/carrier_track/counting/collisions.h"

namespace ricochet::studies::trials {

/// Thrown by what is heard after the last that is of interest.
struct Enough {};

/// Ends a simulation whose impacts, counted or not, are more than a search waits for: that is
/// louder than anything in the paper.
class MostImpacts {
 public:
  static constexpr int most = 20000;

  void pass() {
    if (++heard_ > most) throw Enough();
  }

 private:
  int heard_ = 0;
};

}  // namespace ricochet::studies::trials
