#pragma once

#include <cmath>
#include <vector>

#include "ricochet/recording.h"
#include "src/research/calibration/variants/early_stopping.h"
#include "src/research/calibration/variants/motion_change.h"

namespace ricochet::studies::variants {

/// The path x(t) [m], sampled at fixed steps: at 0, step, 2 step, ... [s].
class SampledPath : public VariantObserver {
 public:
  explicit SampledPath(double step) : step_(step) {}

  void impact(double /*time*/, carrier_track::Wall /*wall*/, double /*speed*/) { limit_.pass(); }

  template <class Path>
  void stretch(double time, const Path& path, double duration) {
    for (;;) {
      const double at = static_cast<double>(samples_.size()) * step_ - time;
      if (at > duration) return;
      samples_.push_back(path.at(std::fmax(at, 0.0)).position);
    }
  }

  const std::vector<double>& samples() const { return samples_; }

 private:
  double step_;
  ImpactLimit limit_;
  std::vector<double> samples_;
};

}  // namespace ricochet::studies::variants
