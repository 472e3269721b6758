#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/regimes/border_curve.h"
#include "ricochet/machine.h"

/// The long run of machines that differ in two numbers: a map of a constant and the speed, or of
/// two constants.
namespace ricochet::carrier_track::inline regimes {

inline constexpr int usual_values = 61;
inline constexpr int map_heights = 120;  ///< numbers along the other axis
inline constexpr int map_phases = 32;    ///< of a disturbance, in each cell
inline constexpr int map_turns = 8;      ///< that are counted from each phase

/// A number of the machine and its range.
struct MapAxis {
  std::string key;  ///< see continuation_constants(), or "omega"
  double from, to;  ///< in its own unit, from < to
};

struct RegimeMapOptions {
  MapAxis over;                           ///< a constant
  int values = usual_values;              ///< of it, evenly spaced, both ends among them
  MapAxis against = {"omega", 0.01, 18};  ///< the speed, or another constant
};

/// The machines with one value of the constant.
struct MapColumn {
  double value;
  /// Collisions in a turn in the long run at the heights: the mean of a motion that repeats,
  /// nothing if it does not; under a disturbance the most in map_turns turns from each of
  /// map_phases phases, so that rarer turns may be missed. Fewer cells if a TimeLimit was reached.
  std::vector<std::optional<double>> cells;
};

struct MapPoint {
  double constant;
  double omega;                 ///< [rad/s], or the other constant
  std::optional<double> slope;  ///< missing where the border is not followed
};

/// A border over the constant.
struct MapCurve {
  std::optional<RegimeEnd> kind;  ///< missing if the border is that of a level of the cells
  double slower, faster;          ///< most collisions a turn on both sides
  std::vector<MapPoint> points;   ///< by rising constant, within the map
  CurveEnd begins, ends;          ///< why it goes no farther at its first, its last point
  std::optional<double> own;      ///< [rad/s], at the machine's own constant
};

struct RegimeMap {
  RegimeMapOptions options;
  double own;              ///< the machine's own value of the constant
  bool disturbed = false;  ///< whether a disturbance shakes some of the machines
  bool followed = false;   ///< whether the curves are borders of the machine, see regime_map()
  bool complete = true;    ///< false if a TimeLimit was reached
  std::vector<double> heights = {};     ///< along the other axis, the middles of equal parts of it
  std::vector<MapColumn> columns = {};  ///< by rising constant
  std::vector<MapCurve> curves = {};
};

/// The map of a valid machine. Each cell is simulated: all machines of a column begin at the state
/// in which the one below ended, as if the speed rose slowly, settle, and are counted.
///
/// The curves are the borders of the machine's own regimes, followed over the constant to the right
/// and to the left; see BorderCurve. Under a disturbance, or against another constant than the
/// speed, there are no such borders. Then each curve is where a column, from its lowest cell up,
/// first passes a count, right to half a cell, for the lowest counts.
///
/// Throws InputError for an unknown key, an invalid range, a range that leaves the valid machines,
/// or as regimes_of() does. If a TimeLimit is reached, columns are shorter. In parallel.
RegimeMap regime_map(const Scene& machine, const RegimeMapOptions& options);

}  // namespace ricochet::carrier_track::inline regimes
