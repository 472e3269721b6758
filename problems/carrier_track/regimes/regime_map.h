#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/regimes/border_curve.h"
#include "ricochet/machine.h"

/// The regimes of machines that differ in one constant: a map of speed and constant.
namespace ricochet::carrier_track::inline regimes {

inline constexpr int usual_values = 61;
inline constexpr int few_values = 13;

struct RegimeMapOptions {
  std::string constant;  ///< see continuation_constants()
  double from, to;       ///< of the constant, in its own unit, from < to
  /// Values of the constant, evenly spaced, both ends among them, at which the regimes are solved;
  /// the machine's own comes on top, and more where neighbours differ. If missing: usual_values, or
  /// under a disturbance few_values, none on top but the machine's own.
  std::optional<int> values = {};
  RegimeOptions speeds = {};
};

/// A machine of the map.
struct MapColumn {
  double constant;
  std::vector<Regime> regimes;
};

/// A point of a border; the slope is missing under a disturbance, whose borders are not followed.
struct MapPoint {
  double constant;
  double omega;  ///< [rad/s]
  std::optional<double> slope;
};

/// A border over the constant, as the carrier meets it while the speed rises slowly.
struct MapCurve {
  RegimeEnd kind;
  double slower, faster;         ///< most collisions a turn on both sides
  std::vector<MapPoint> points;  ///< by rising constant, within the range of speeds
  CurveEnd begins, ends;         ///< why it goes no farther at its first, its last point
  std::optional<double> own;     ///< [rad/s], at the machine's own constant, if it is met there
};

/// A region in which the most collisions a turn are the same: a strip between two lines.
struct MapRegion {
  double collisions;  ///< most in a turn
  bool certain;       ///< false where the motion does not repeat
  struct Edge {
    double constant;
    double lower, upper;  ///< [rad/s], perhaps beyond the range of speeds
  };
  std::vector<Edge> edges;  ///< by rising constant
};

struct RegimeMap {
  RegimeMapOptions options;
  double own;                      ///< the machine's own value of the constant
  bool followed;                   ///< false under a disturbance
  std::vector<MapColumn> columns;  ///< by rising constant
  std::vector<MapCurve> curves;    ///< by their speed at the first point
  std::vector<MapRegion> regions;  ///< they cover the map

  /// The most collisions in a turn of a machine of the map; nothing outside of it.
  std::optional<double> collisions_at(double constant, double omega) const;
};

/// The map of a valid machine. Its borders are followed from value to value of the constant by
/// continuation; where that does not lead from the regimes at one value to those at the next, the
/// regimes at more values between are solved. Under a disturbance, and beside motions that do not
/// repeat, borders of one kind and count are joined by straight lines. Throws InputError for an
/// unknown constant, an invalid range, a range that leaves the valid machines, or as regimes_of()
/// does; TimeLimitReached. In parallel.
RegimeMap regime_map(const Scene& machine, const RegimeMapOptions& options);

}  // namespace ricochet::carrier_track::inline regimes
