#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/motion/observer.h"
#include "ricochet/machine.h"
#include "ricochet/scene.h"
#include "src/core/in_parallel.h"

/// objective() for many scenes, with the same bits. If possible they are simulated side by side
/// (impact_model.h), which is several times as fast. Neighbouring speeds should be similar.
namespace ricochet::carrier_track::inline counting {

/// Counts as objective() does under the rule of impacts, without its logarithm.
struct ImpactCount : Observer {
  static constexpr bool hears_impacts_alone = true;

  struct Enough {};  ///< thrown when the count exceeds `most`

  double counting_limit = 0;
  int most = std::numeric_limits<int>::max();  ///< largest count of interest
  int count = 0;

  void impact(double /*time*/, Wall /*wall*/, double speed) {
    if (is_counted(speed, counting_limit) && ++count > most) throw Enough();
  }
};

/// Returns true if all scenes can be simulated side by side and count impacts.
bool suits_lanes(const Scene& scene);

/// The objectives of valid scenes.
std::vector<double> objectives(std::span<const Scene> scenes, double smoothing);

/// The collision counts of a valid scene at several speeds [rad/s].
std::vector<int> counts_at(const Scene& scene, std::span<const double> speeds);

/// Fills the counts of a scan in parallel, the slowest speeds first; `counts_at(speeds)` counts a
/// block of neighbouring speeds. Returns how many of the slowest speeds are counted: all of them,
/// unless the time limit is reached.
template <class Scan, class CountsAt>
std::size_t count_in_blocks(Scan& scan, const CountsAt& counts_at) {
  constexpr std::size_t block = 32;
  const std::size_t size = scan.counts.size();
  std::vector<char> counted((size + block - 1) / block, 0);
  try {
    in_parallel("scan of the speeds", counted.size(), [&](std::size_t i) {
      std::vector<double> speeds;
      for (std::size_t k = i * block; k < std::min(size, (i + 1) * block); ++k) {
        speeds.push_back(scan.omega(k));
      }
      const std::vector<int> counts = counts_at(std::span<const double>(speeds));
      std::copy(counts.begin(), counts.end(), &scan.counts[i * block]);
      counted[i] = 1;
    });
  } catch (const TimeLimitReached&) {
    // The blocks before the first that had no time are known.
  }
  const auto first_not = std::find(counted.begin(), counted.end(), 0);
  return std::min(size, static_cast<std::size_t>(first_not - counted.begin()) * block);
}

/// The parts of the motion at one speed on which a count depends: every impact that counts or
/// almost counts, every turning point near a wall, and their derivatives with respect to the speed.
class MotionSketch {
 public:
  /// `scene` must be valid for scan_completely(); omega [rad/s] > 0.
  MotionSketch(const Scene& scene, double omega);

  double omega() const { return omega_; }
  int count() const { return count_; }

  /// Returns true if, according to the derivatives at both speeds, no feature starts or stops to
  /// count between this speed and the faster one.
  bool joins(const MotionSketch& faster) const;

 private:
  /// A number and its derivative with respect to the speed [1/(rad/s)].
  struct Sloped {
    double value, slope;
  };
  enum class Kind { lower_impact, upper_impact, lower_graze, upper_graze };
  struct Feature {
    Kind kind;
    Sloped share;   ///< share of the window that has passed
    Sloped margin;  ///< of an impact: see count.h; of a graze: its distance / clearance
  };
  class Watch;

  static bool keeps_sign(const Sloped& a, const Sloped& b, double step);
  const Feature* counterpart(const Feature& feature, double step) const;
  bool joins_by_features_of(const MotionSketch& one, const MotionSketch& other,
                            bool forwards) const;

  double omega_;
  int count_ = 0;
  std::vector<Feature> features_;
};

}  // namespace ricochet::carrier_track::inline counting
