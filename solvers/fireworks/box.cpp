#include "solvers/fireworks/box.h"

#include <algorithm>
#include <cmath>

#include "solvers/fireworks/draws.h"

namespace ricochet::fireworks {

Box::Box(const Vector& lower, const Vector& upper)
    : lower_(lower), upper_(upper), width_(upper_ - lower_) {
  for (Eigen::Index k = 0; k < width_.size(); ++k) {
    if (width_[k] > 0) free_.push_back(k);
  }
}

double Box::drawn(Eigen::Index k, Random& random) const {
  return std::min(lower_[k] + share(random) * width_[k], upper_[k]);
}

void Box::draw(Vector& x, Random& random) const {
  for (Eigen::Index k = 0; k < x.size(); ++k) x[k] = drawn(k, random);
}

void Box::bring_back(Vector& x, Mapping mapping, Random& random) const {
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    if (x[k] >= lower_[k] && x[k] <= upper_[k]) continue;
    if (mapping == Mapping::redraw) {
      x[k] = drawn(k, random);
    } else {
      const double rest = width_[k] > 0 ? std::fmod(std::abs(x[k]), width_[k]) : 0.0;
      x[k] = std::min(lower_[k] + rest, upper_[k]);
    }
  }
}

void Box::bring_near(Vector& x, const Vector& centre, double amplitude, Random& random) const {
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    if (x[k] >= lower_[k] && x[k] <= upper_[k]) continue;
    const double least = std::max(lower_[k], centre[k] - amplitude * width_[k]);
    const double most = std::min(upper_[k], centre[k] + amplitude * width_[k]);
    x[k] = std::clamp(least + share(random) * (most - least), lower_[k], upper_[k]);
  }
}

}  // namespace ricochet::fireworks
