#include "problems/carrier_track/counting/feature_trace.h"

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/counting/collisions.h"
#include "ricochet/recording.h"

namespace ricochet::carrier_track::inline counting {

void FeatureTrace::impact(double time, Wall wall, double speed) {
  now_ = time;
  finite_ = finite_ && std::isfinite(time + speed);
  const std::size_t kind = wall == Wall::lower ? lower_impact : upper_impact;
  impacts_[kind].push_back(time);
  if (scene_.rule != CountRule::impacts || speed <= 0) return;
  const double counting_limit = scene_.counting_limit;
  tell(kind, is_counted(speed, counting_limit) ? impact_margin(speed, counting_limit)
                                               : speed / counting_limit - 1);
}

void FeatureTrace::peak(double time, double position) {
  // A maximum is reported when the body starts to move down from it, which is now.
  std::size_t kind = high_peak;
  const auto keep = [&](double z, double /*left*/) {
    tell(kind++, z > 0 ? z : std::expm1(z));
    counting_peak_ = counting_peak_ || (z > 0 && position < scene_.wall_upper);
  };
  Features<double, decltype(keep)>(scene_, keep).peak(time, position);
}

void FeatureTrace::hops(double time, Wall wall) {
  if (scene_.rule != CountRule::peaks || endless_) return;
  // Their maxima lie on the upper wall, or arbitrarily near the lower one.
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

double FeatureTrace::reach() const {
  double reach = 0;
  for (const double x : {scene_.wall_lower, scene_.wall_upper, scene_.start_position}) {
    if (std::isfinite(x)) reach = std::max(reach, std::abs(x));
  }
  return reach;
}

void FeatureTrace::tell(std::size_t kind, double scaled) {
  finite_ = finite_ && std::isfinite(now_ + scaled);
  features_[kind].push_back({now_, scaled});
}

void FeatureTrace::turn(double time, double position, Wall ahead) {
  finite_ = finite_ && std::isfinite(time + position);
  const double distance =
      ahead == Wall::upper ? scene_.wall_upper - position : position - scene_.wall_lower;
  if (!(distance > 0) || std::isinf(distance)) return;
  if (!graze_ || distance < graze_->distance) graze_ = Graze{time, ahead, distance};
}

}  // namespace ricochet::carrier_track::inline counting
