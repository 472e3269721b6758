#include "problems/carrier_track/counting/complete_scan.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "problems/carrier_track/counting/counts.h"
#include "problems/carrier_track/counting/motion_sketch.h"
#include "ricochet/threshold.h"

namespace ricochet::carrier_track::inline counting {
namespace {

/// The largest step, as a share of the speed, and in rad/s.
constexpr double widest_share = 0.05;
constexpr double widest = 0.05;

class Scan {
 public:
  Scan(const Scene& scene, const CompleteScanOptions& options) : scene_(scene), options_(options) {}

  /// Returns false if it takes too many simulations.
  bool cover(double lowest, double highest) {
    MotionSketch here = sketch(lowest);
    add(here);
    constexpr double head_start = 500;
    while (here.omega() < highest) {
      const double step = std::min(widest, widest_share * here.omega());
      const double done = (here.omega() + step - lowest) / (highest - lowest);
      allowed_ = static_cast<std::int64_t>(head_start + done * static_cast<double>(options_.most));
      MotionSketch next = sketch(std::min(highest, here.omega() + step));
      if (!join(here, next)) return false;
      here = std::move(next);
    }
    return true;
  }

  CompleteScan take() { return std::move(scan_); }

 private:
  MotionSketch sketch(double omega) {
    ++scan_.simulations;
    return MotionSketch(scene_, omega);
  }

  bool join(const MotionSketch& a, const MotionSketch& b) {
    if (a.joins(b)) {
      scan_.pieces.back().to = b.omega();
      return true;
    }
    if (b.omega() - a.omega() <= options_.resolution) {
      add(b);
      return true;
    }
    if (scan_.simulations >= allowed_) return false;
    const MotionSketch middle = sketch((a.omega() + b.omega()) / 2);
    return join(a, middle) && join(middle, b);
  }

  void add(const MotionSketch& at) {
    auto& pieces = scan_.pieces;
    if (!pieces.empty() && pieces.back().count == at.count()) {
      pieces.back().to = at.omega();
    } else {
      pieces.push_back({at.omega(), at.omega(), at.count()});
    }
  }

  const Scene& scene_;
  const CompleteScanOptions& options_;
  std::int64_t allowed_ = 0;  // simulations, up to here
  CompleteScan scan_;
};

}  // namespace

std::optional<CountPiece> CompleteScan::first_above(double limit) const {
  for (const CountPiece& piece : pieces) {
    if (piece.count > limit) return piece;
  }
  return std::nullopt;
}

std::optional<CompleteScan> scan_completely(const Scene& scene, double lowest, double highest,
                                            const CompleteScanOptions& options) {
  if (!suits_lanes(at_speed(scene, lowest))) {
    throw std::invalid_argument("only impacts on hard walls at constant speed can be scanned so");
  }
  Scan scan(scene, options);
  if (!scan.cover(lowest, highest)) return std::nullopt;
  return scan.take();
}

}  // namespace ricochet::carrier_track::inline counting
