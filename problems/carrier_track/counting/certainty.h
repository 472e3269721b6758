#pragma once

#include <optional>
#include <string>

#include "problems/carrier_track/counting/feature_trace.h"
#include "problems/carrier_track/counting/neighbours.h"

/// How far a count can be trusted. A scene's constants are known to some digits only, and a
/// simulation rounds. So the scene is simulated again with all constants changed at once in their
/// tenth digit (perturbation.h), and the features of the motion (collisions.h) are compared one by
/// one. A count is certain if no feature comes to count, or ceases to, by such a change. It is not
/// where infinitely many maxima count, where the change makes the walls cross, and where numbers
/// overflow.
namespace ricochet::carrier_track::inline counting {

/// Why a count is not certain: the first cause in time.
enum class Doubt {
  none,
  margin,     ///< the change takes a feature's margin z to or across zero
  window,     ///< the change takes a feature that counts to or across the end of the window
  graze,      ///< a wall is touched or missed, or a maximum is there or not, with the change
  sensitive,  ///< the change has grown beyond 1e6-fold, or leads to a motion that is refused
  endless     ///< maxima count of which there is no last one, see FeatureTrace
};

struct Certainty {
  /// Whether no doubt was found: every feature that counts has its counterpart in every changed
  /// scene, and each margin is further from zero than it moves, and than perturbation_size.
  bool certain = true;
  std::optional<double> margin;  ///< smallest |z| of all features; nothing without features
  std::optional<Graze> graze;    ///< the nearest of the window; nothing without a turning point
  /// Largest difference of a feature's scaled margin between a changed scene and the given one, in
  /// units of perturbation_size, of the features up to the first in doubt; 0 without features.
  double growth = 0;
  Doubt doubt = Doubt::none;
  std::string reason;  ///< the doubt as a sentence without a full stop; empty if certain
};

/// Certainty of the count of a valid scene, of which `trace` and neighbours are given; where these
/// are not simulated yet and it hangs on them, they are now.
Certainty certainty_of(const Scene& scene, const FeatureTrace& trace, Neighbours& neighbours);

}  // namespace ricochet::carrier_track::inline counting
