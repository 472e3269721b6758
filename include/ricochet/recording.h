#pragma once

/// @file
/// The results of a simulation.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline models {

enum class Wall { lower, upper };

/// The state in which a simulation ended.
template <class Scalar>
struct End {
  Scalar time;               ///< [s]
  Scalar position;           ///< [m]
  Scalar velocity;           ///< [m/s]
  std::int64_t evaluations;  ///< of the closed-form flight
};

}  // namespace ricochet::carrier_track::inline models

namespace ricochet::carrier_track::inline counting {

/// A turning point that comes near the wall ahead of it without touching it.
struct Graze {
  double time;  ///< [s]
  Wall wall;
  double distance;  ///< [m], > 0
};

/// Why a count is not certain: the first cause in time.
enum class Doubt {
  none,
  margin,     ///< the change moves a feature's margin z to or across zero
  window,     ///< the change moves a feature that counts to or across the end of the window
  graze,      ///< the change makes an impact or a maximum appear or vanish
  sensitive,  ///< the change grows more than 1e6-fold, or its simulation fails
  endless,    ///< infinitely many maxima count, see FeatureTrace
  unfinished  ///< a TimeLimit was reached before the end of the simulation or of the comparison
};

struct Certainty {
  /// True if there is no doubt: every feature that counts has a counterpart in every changed scene,
  /// and each |margin| is larger than its change and than perturbation_size.
  bool certain = true;
  std::optional<double> margin;  ///< smallest |z| of all features; nothing without features
  std::optional<Graze> graze;    ///< the nearest in the window; nothing without a turning point
  /// Largest difference of a feature's scaled margin between a changed scene and the given one, in
  /// units of perturbation_size, of the features up to the first in doubt; 0 without features.
  double growth = 0;
  Doubt doubt = Doubt::none;
  std::string reason;  ///< the doubt as a sentence without a full stop; empty if certain
};

struct Impact {
  double time;  ///< [s]
  Wall wall;
  double speed;  ///< [m/s], approach speed
};

struct Peak {
  double time;      ///< [s]
  double position;  ///< [m]
};

struct Sample {
  double time;      ///< [s]
  double position;  ///< [m]
  double velocity;  ///< [m/s]
};

/// All results of one simulation.
struct Recording {
  Fidelity fidelity = Fidelity::impact;  ///< the level simulated; for auto the one needed
  int count = 0;
  double surrogate = 0;
  Certainty certainty;  ///< of the count
  /// Whether the whole window was simulated; if not, because a TimeLimit was reached, all is that
  /// of the time up to end.time, and end.velocity is NaN.
  bool complete = true;
  std::vector<Impact> impacts;
  std::vector<Peak> peaks;
  std::vector<Sample> path;
  End<double> end{};
};

}  // namespace ricochet::carrier_track::inline counting
