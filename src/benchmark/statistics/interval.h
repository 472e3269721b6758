#pragma once

namespace ricochet {

/// A closed interval; the upper end may be infinite.
struct Interval {
  double lower, upper;
};

}  // namespace ricochet
