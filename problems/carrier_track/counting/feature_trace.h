#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "problems/carrier_track/models/observer.h"
#include "problems/carrier_track/scene/perturbation.h"
#include "ricochet/recording.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline counting {

/// Records of a simulation, for comparison with that of a slightly different scene: its features
/// (collisions.h), impacts and nearest graze.
class FeatureTrace : public Observer {
 public:
  struct Feature {
    double time;  ///< [s], when it is known to count
    /// z if the feature counts, else exp(z) - 1 (under the rule of impacts minus the missing share
    /// of the speed), which changes little for features that are far from counting.
    double scaled;

    bool counts() const { return scaled > 0; }
    double margin() const { return counts() ? scaled : std::log1p(scaled); }  ///< z
  };
  enum Kind : std::size_t { lower_impact, upper_impact, high_peak, low_peak, kinds };

  /// `scene` must outlive the trace.
  explicit FeatureTrace(const Scene& scene) : scene_(scene) {
    for (std::vector<double>& times : impacts_) times.reserve(usual_impacts);
    if (scene.rule != CountRule::impacts) return;
    for (const Kind kind : {lower_impact, upper_impact}) features_[kind].reserve(usual_impacts);
  }

  void impact(double time, Wall wall, double speed);
  void peak(double time, double position);
  void turn(double time, double position, Wall ahead);
  void hops(double time, Wall wall);
  void contact(double time, double position, double velocity);

  /// True if maxima count. Under the rule of impacts, impacts and turning points suffice.
  bool hears_stretches() const { return scene_.rule == CountRule::peaks; }

  template <class Path>
  void stretch(double time, const Path& path, double duration) {
    finite_ = finite_ && std::isfinite(path.position + path.velocity + time + duration);
    swung_out_ = false;
    if (std::exchange(counting_peak_, false)) {
      const double drop = path.position - path.at(duration).position;
      if (drop <= perturbation_size * (path.position - scene_.wall_lower)) shallow_ = time;
    }
    now_ = time + duration;
  }

  /// The features of a Kind, in order of time.
  const std::vector<Feature>& features(std::size_t kind) const { return features_[kind]; }
  const std::vector<double>& impacts(Wall wall) const {
    return impacts_[wall == Wall::lower ? lower_impact : upper_impact];
  }
  const std::optional<Graze>& graze() const { return graze_; }

  /// Infinitely many maxima that count: of ever smaller rebounds on a wall, or of ever smaller
  /// oscillations in a compliant wall. A simulation reports only some of them.
  struct Endless {
    double time;  ///< [s]
    Wall wall;
  };
  const std::optional<Endless>& endless() const { return endless_; }

  /// Time [s] of a maximum off the walls that counts and from which the body fell by less than the
  /// tenth digit of its height. Rounding makes such a maximum if the speed only touches zero.
  const std::optional<double>& shallow_peak() const { return shallow_; }

  /// The largest finite coordinate [m] of walls and start.
  double reach() const;

  /// Returns true if all reported values are finite; they are not if numbers overflow.
  bool finite() const { return finite_; }

 private:
  static constexpr std::size_t usual_impacts = 64;  // on one wall

  void tell(std::size_t kind, double scaled);

  const Scene& scene_;
  std::array<std::vector<Feature>, kinds> features_;
  std::array<std::vector<double>, 2> impacts_;  // times [s]
  std::optional<Graze> graze_;
  double now_ = 0;  // [s]
  std::optional<Endless> endless_;
  std::optional<double> shallow_;
  bool counting_peak_ = false;  // true while the body falls from a maximum that counts
  bool finite_ = true;
  bool swung_out_ = false;  // true if the body has moved outwards in its present contact
};

}  // namespace ricochet::carrier_track::inline counting
