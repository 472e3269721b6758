#pragma once

#include <cmath>
#include <vector>

#include "src/studies/trials/most_impacts.h"
#include "src/studies/trials/what_if.h"

namespace ricochet::studies::trials {

/// The path x(t) [m] as a recording at fixed steps has it: at 0, step, 2 step, ... [s].
class SampledPath : public WhatIfObserver {
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
  MostImpacts limit_;
  std::vector<double> samples_;
};

}  // namespace ricochet::studies::trials
