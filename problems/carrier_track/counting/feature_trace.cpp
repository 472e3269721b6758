#include "problems/carrier_track/counting/feature_trace.h"

#include <cmath>

#include "problems/carrier_track/counting/collisions.h"

namespace ricochet::carrier_track::inline counting {

void FeatureTrace::impact(double time, Wall wall, double speed) {
  now_ = time;
  finite_ = finite_ && std::isfinite(time + speed);
  const std::size_t kind = wall == Wall::lower ? lower_impact : upper_impact;
  impacts_[kind].push_back(time);
  const auto keep = [&](double z, double /*left*/) { tell(kind, z, speed / scene_.slowest - 1); };
  Features<double, decltype(keep)>(scene_, keep).impact(time, wall, speed);
}

void FeatureTrace::peak(double time, double position) {
  // It is told when the body moves down from it, which is now.
  std::size_t kind = high_peak;
  const auto keep = [&](double z, double /*left*/) {
    tell(kind++, z, std::expm1(z));
    counting_peak_ = counting_peak_ || (z > 0 && position < scene_.wall_upper);
  };
  Features<double, decltype(keep)>(scene_, keep).peak(time, position);
}

void FeatureTrace::hops(double time, Wall wall) {
  if (scene_.rule != CountRule::peaks || endless_) return;
  // Their maxima lie on the upper wall, or as near the lower one as one likes.
  const double height = wall == Wall::upper ? scene_.wall_upper : scene_.wall_lower;
  if (height >= scene_.peak_high || height <= scene_.peak_low) endless_ = Endless{time, wall};
}

void FeatureTrace::contact(double time, double position, double velocity) {
  now_ = time;
  const bool upper = scene_.wall_upper - position < position - scene_.wall_lower;
  const double inward = upper ? velocity : -velocity;
  if (inward > 0 && swung_out_) hops(time, upper ? Wall::upper : Wall::lower);
  swung_out_ = swung_out_ || inward < 0;
}

void FeatureTrace::tell(std::size_t kind, double margin, double missing) {
  finite_ = finite_ && std::isfinite(now_ + margin);
  features_[kind].push_back({now_, margin, margin > 0 ? margin : missing});
}

void FeatureTrace::turn(double time, double position, Wall ahead) {
  finite_ = finite_ && std::isfinite(time + position);
  const double distance =
      ahead == Wall::upper ? scene_.wall_upper - position : position - scene_.wall_lower;
  if (!(distance > 0) || std::isinf(distance)) return;
  if (!graze_ || distance < graze_->distance) graze_ = Graze{time, ahead, distance};
}

}  // namespace ricochet::carrier_track::inline counting
