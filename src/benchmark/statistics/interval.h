#pragma once

namespace ricochet {

/// Both ends belong to it; the upper one may be infinite.
struct Interval {
  double lower, upper;
};

}  // namespace ricochet
