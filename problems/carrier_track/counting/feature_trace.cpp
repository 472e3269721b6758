#include "problems/carrier_track/counting/feature_trace.h"

#include <cmath>

#include "problems/carrier_track/counting/collisions.h"

namespace ricochet::carrier_track::inline counting {

void FeatureTrace::impact(double time, Wall wall, double speed) {
  if (ahead_ == wall) ahead_.reset();
  now_ = time;
  const std::size_t kind = wall == Wall::lower ? lower_impact : upper_impact;
  impacts_[kind].push_back(time);
  const auto keep = [&](double z, double /*left*/) { tell(kind, z); };
  Features<double, decltype(keep)>(scene_, keep).impact(time, wall, speed);
}

void FeatureTrace::peak(double time, double position) {
  // It is told when the body moves down from it, which is now.
  std::size_t kind = high_peak;
  const auto keep = [&](double z, double /*left*/) { tell(kind++, z); };
  Features<double, decltype(keep)>(scene_, keep).peak(time, position);
}

void FeatureTrace::tell(std::size_t kind, double margin) {
  features_[kind].push_back({now_, margin, margin > 0 ? margin : std::expm1(margin)});
}

void FeatureTrace::turn(double time, double position) {
  const double distance =
      *ahead_ == Wall::upper ? scene_.wall_upper - position : position - scene_.wall_lower;
  if (!(distance > 0) || std::isinf(distance)) return;
  if (!graze_ || distance < graze_->distance) graze_ = Graze{time, *ahead_, distance};
}

}  // namespace ricochet::carrier_track::inline counting
