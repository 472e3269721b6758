#pragma once

#include <cstdint>

#include "problems/carrier_track/reference_integrators/forces.h"

namespace ricochet::carrier_track::inline reference_integrators {

/// The walls a flight may end at [m]; the upper one may be infinitely far.
struct Bias {
  double lower, upper;
};

/// What a flight method needs of a scene.
struct FlightSetting {
  Forces forces;
  Bias gap;
  double window;  ///< [s]
  double length;  ///< [m]; absolute tolerances are the relative one times this (and [m/s] alike)
};

/// `length` is the width of the gap; with an infinite one the start's height above the lower wall,
/// and 1 m for a start on it.
FlightSetting flight_setting(const BasicScene<double>& scene);

/// A stretch of motion without impact, which starts at rest or moves in `direction`. With friction
/// it has to end when the velocity comes down to zero; without, it may turn and go on.
struct Leg {
  double start;    ///< [s] from the start of the window
  State state;     ///< within the gap
  int direction;   ///< +1 or -1
  double longest;  ///< [s], > 0; the rest of the window
};

enum class Finish { lower_wall, upper_wall, turn, limit };

struct Landing {
  Finish finish;
  double duration;  ///< [s] from the start of the leg
  State state;      ///< as integrated, so a little off the wall or off zero velocity
};

/// An integrator with event location, for smooth motion between impacts. A method object serves all
/// legs of one run, so that what it allocates and learns is kept.
class FlightMethod {
 public:
  virtual ~FlightMethod() = default;

  /// Throws std::runtime_error where the method fails or needs more than most_steps in all.
  virtual Landing fly(const Leg& leg) = 0;

  /// Evaluations of the forces so far.
  virtual std::int64_t evaluations() const = 0;
};

/// A method that takes more steps than this in a run has run away.
inline constexpr std::int64_t most_steps = 1'000'000;

}  // namespace ricochet::carrier_track::inline reference_integrators
