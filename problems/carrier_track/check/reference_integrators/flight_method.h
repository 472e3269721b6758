#pragma once

#include <cstdint>

#include "problems/carrier_track/check/reference_integrators/forces.h"

namespace ricochet::carrier_track::inline reference_integrators {

/// The walls that end a flight [m]; the upper one may be at infinity.
struct Bias {
  double lower, upper;
};

/// What a flight method needs to know of a scene.
struct FlightSetting {
  Forces forces;
  Bias gap;
  double window;  ///< [s]
  double length;  ///< [m]; absolute tolerances are the relative one times this (and [m/s] alike)
};

/// `length` is the width of the gap; if it is infinite, the start's height above the lower wall, or
/// 1 m for a start on that wall.
FlightSetting flight_setting(const BasicScene<double>& scene);

/// A flight without impact, which starts at rest or moves in `direction`. With friction it must end
/// at zero velocity; without, the body may turn and continue.
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
  State state;      ///< as integrated, so slightly off the wall or off zero velocity
};

/// An integrator with event location, for smooth motion between impacts. One object serves all legs
/// of a run, so that it keeps its memory and history.
class FlightMethod {
 public:
  virtual ~FlightMethod() = default;

  /// Throws std::runtime_error if the method fails or needs more than most_steps in all.
  virtual Landing fly(const Leg& leg) = 0;

  /// Evaluations of the forces so far.
  virtual std::int64_t evaluations() const = 0;
};

/// A method that takes more steps than this in a run is stopped.
inline constexpr std::int64_t most_steps = 1'000'000;

}  // namespace ricochet::carrier_track::inline reference_integrators
