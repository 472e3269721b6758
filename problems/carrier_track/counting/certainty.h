#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/models/impact_model.h"

/// How far a count can be trusted. A scene's constants are known to some digits only, and a
/// simulation rounds. So the scene is simulated again with all constants changed at once, and the
/// features of the motion (collisions.h) are compared one by one.
namespace ricochet::carrier_track::inline counting {

/// What a certain count stands: a relative change of every constant by up to this much. It is the
/// tenth digit, some million times what rounding does.
inline constexpr double constants_change = 1e-9;

/// A turning point that comes near the wall ahead of it without touching it.
struct Graze {
  double time;  ///< [s]
  Wall wall;
  double distance;  ///< [m], > 0
};

/// Why a count is not certain: the first cause in time.
enum class Doubt {
  none,
  margin,    ///< the change takes a feature's margin z to or across zero
  window,    ///< the change takes a feature that counts to or across the end of the window
  graze,     ///< a wall is touched or missed, or a maximum is there or not, with the change
  sensitive  ///< the change has grown beyond 1e6-fold, or leads to a motion that is refused
};

struct Certainty {
  /// Whether no doubt was found: every feature that counts has its counterpart in every changed
  /// scene, and each margin is further from zero than it moves, and than constants_change.
  bool certain = true;
  std::optional<double> margin;  ///< smallest |z| of all features; nothing without features
  std::optional<Graze> graze;    ///< the nearest of the window; nothing without a turning point
  /// Largest |s(z') - s(z)| / constants_change, z' being the margin of the feature in a changed
  /// scene, over the features up to the first in doubt; 0 without features. s(z) is z where a
  /// feature counts and exp(z) - 1 where not, for a rule of impacts the speed's share that is
  /// missing: features far too slow to count do not matter.
  double growth = 0;
  Doubt doubt = Doubt::none;
  std::string reason;  ///< the doubt as a sentence without a full stop; empty if certain
};

/// What is compared of a simulation: its features, impacts and nearest graze.
class FeatureTrace : public Observer {
 public:
  struct Feature {
    double time;    ///< [s], from which on it is known to count
    double margin;  ///< z
    double scaled;  ///< s(z) of Certainty::growth
  };
  enum Kind : std::size_t { lower_impact, upper_impact, high_peak, low_peak, kinds };

  /// Of a scene that outlives the trace.
  explicit FeatureTrace(const Scene& scene) : scene_(scene) {}

  void impact(double time, Wall wall, double speed);
  void peak(double time, double position);
  void contact(double time, double /*position*/, double /*velocity*/) { now_ = time; }

  /// A stretch without reversal; a turning point lies between one and the next if no impact does.
  template <class Path>
  void stretch(double time, const Path& path, double duration) {
    const auto start = path.at(0.0);
    if (ahead_ && !((*ahead_ == Wall::upper ? 1 : -1) * start.velocity > 0)) {
      turn(time, start.position);
    }
    ahead_.reset();
    now_ = time + duration;
    const double velocity = start.velocity != 0 ? start.velocity : path.at(0.5 * duration).velocity;
    if (velocity != 0) ahead_ = velocity > 0 ? Wall::upper : Wall::lower;
  }

  /// In order of time.
  const std::vector<Feature>& features(std::size_t kind) const { return features_[kind]; }
  const std::vector<double>& impacts(Wall wall) const {
    return impacts_[wall == Wall::lower ? lower_impact : upper_impact];
  }
  const std::optional<Graze>& graze() const { return graze_; }

 private:
  void tell(std::size_t kind, double margin);
  void turn(double time, double position);

  const Scene& scene_;
  std::array<std::vector<Feature>, kinds> features_;
  std::array<std::vector<double>, 2> impacts_;  // times [s]
  std::optional<Graze> graze_;
  double now_ = 0;             // [s]
  std::optional<Wall> ahead_;  // where the last stretch led, if no impact ended it
};

/// Certainty of the count of a valid scene, of which `trace` is given. Simulates the scene four
/// times: all its constants are changed at once, each by 0.5 to 1 times constants_change, in two
/// patterns of signs and their opposites. Kept are zeros, the exponent of a contact, restitutions
/// of 1 from above, and the contact of a body that starts on a wall. Lengths are changed by a share
/// of the largest coordinate, the phase by that of a radian or more. The limits of the rule and the
/// window are not changed: a margin must exceed constants_change anyway.
Certainty certainty_of(const Scene& scene, const FeatureTrace& trace);

}  // namespace ricochet::carrier_track::inline counting
