#include "problems/carrier_track/regimes/kept_sign.h"

#include <algorithm>
#include <cmath>

namespace ricochet::carrier_track::inline regimes {

bool keeps_sign(const Margin& a, const Margin& b, double step) {
  if ((a.value > 0) != (b.value > 0)) return false;
  const double sign = a.value > 0 ? 1 : -1;
  const double from = sign * a.value, to = sign * b.value;
  const double leaves = sign * step * a.slope, arrives = sign * step * b.slope;
  const double surprise = std::abs(to - from - (leaves + arrives) / 2);
  if (surprise > 0.5 * (from + to)) return false;
  const double square = 3 * (to - from) - 2 * leaves - arrives;
  const double cube = leaves + arrives - 2 * (to - from);
  // The least value within the step, where 3 cube t^2 + 2 square t + leaves = 0 and it rises.
  const double root = square * square - 3 * cube * leaves;
  if (root < 0) return true;
  const double t =
      square > 0 ? -leaves / (square + std::sqrt(root)) : (std::sqrt(root) - square) / (3 * cube);
  if (!(t > 0 && t < 1)) return true;
  const double least = from + t * (leaves + t * (square + t * cube));
  return least > 0.1 * surprise + 0.4 * (std::min(from, to) - least);
}

}  // namespace ricochet::carrier_track::inline regimes
