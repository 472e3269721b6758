#pragma once

#include <span>
#include <string>
#include <vector>

#include "problems/carrier_track/models/dual_simulation.h"
#include "problems/carrier_track/regimes/steady_motion.h"
#include "ricochet/scene.h"
#include "ricochet/vector.h"

/// Exact derivatives of a periodic motion, by dual numbers.
namespace ricochet::carrier_track::inline regimes {

/// One period of an orbit in dual numbers. Their derivatives are with respect to position, velocity
/// (both at the start of the period), speed of the driver plate, and up to two constants.
struct OrbitMap {
  using Number = DesignDual;
  static constexpr int position_index = 0, velocity_index = 1, omega_index = 2, constant_index = 3;

  std::vector<Number> speeds;  ///< [m/s], approach speeds of the impacts, by time
  std::vector<Wall> walls;     ///< of these impacts
  std::vector<Number> misses;  ///< [m] > 0, distances by which turning points miss a wall
  Number position, velocity;   ///< [m], [m/s], at the end
};

/// The constants of a scene that a border can be followed over, by the keys of its file, and
/// `clearance`: the upper wall moves.
std::vector<std::string> continuation_constants();

/// Sets the constant of that key, of a plain scene. Throws InputError for a key that is not among
/// continuation_constants().
void set_constant(Scene& scene, const std::string& key, double to);
double constant_named(const Scene& scene, const std::string& key);

/// Makes that constant of a scene the dual number's variable of that index.
void vary_constant(BasicScene<OrbitMap::Number>& scene, const std::string& key, int index);

/// The period that starts at `orbit`'s start, at rest if `rest` says so. At most two constants.
OrbitMap map_of(const Scene& orbit, Rest rest, std::span<const std::string> constants = {});

/// Derivatives along the orbit: how a number of the period changes with the speed and the constants
/// while the start follows, so that the motion stays periodic (implicit function theorem).
class AlongOrbit {
 public:
  AlongOrbit(const OrbitMap& map, Rest rest);

  /// The total derivative of `number` with respect to the speed (index 2) or a constant (3, 4).
  double operator()(const OrbitMap::Number& number, int index) const;

 private:
  double position_[3] = {};  // derivatives of the start
  double velocity_[3] = {};
};

/// Trace and determinant of the map's Jacobian.
struct MapInvariants {
  double trace, determinant;
};
MapInvariants invariants_of(const OrbitMap& map, Rest rest);

}  // namespace ricochet::carrier_track::inline regimes
