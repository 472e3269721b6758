#pragma once

#include <vector>

#include "problems/carrier_track/check/push.h"
#include "problems/carrier_track/counting/recording.h"
#include "ricochet/machine.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline oracle {

/// A point where a rising body stops without reaching the upper wall.
struct Summit {
  double time;         ///< [s]
  long double height;  ///< [m] above the lower wall
};

/// The oracle's result for a scene.
struct OracleRun {
  int count = 0;                ///< by the scene's rule, up to the end or the cap
  bool finished = true;         ///< whether the end of the window was reached within the caps
  std::vector<Impact> impacts;  ///< in order of time, without the end of a Zeno sequence
  std::vector<Summit> summits;
  std::vector<Peak> maxima;  ///< of x, on a wall too, without the end of a Zeno sequence
  bool endless = false;      ///< the omitted ones count, infinitely many: there is no count
};

/// A run stops at this number of impacts: beyond, its window holds no useful count.
inline constexpr std::size_t oracle_impact_cap = 2000;

/// Simulates fidelity `impact` for a valid scene: hard walls, Newton restitution, set-valued
/// Coulomb friction. Independent of the impact model, with which it shares neither code nor method:
/// 80-bit long double, the power series of push.h, and roots isolated by first_fall.h. A grazing
/// impact is decided by the distance to the wall at the turning point itself. The rest of a Zeno
/// sequence is omitted only if it is proved that the body comes to rest on the wall before the
/// force changes direction, with no impact faster than a thousandth of `counting_limit`, and, if
/// maxima count, before the window ends.
OracleRun oracle_run(const Scene& scene);

/// The same under other applied forces in place of the scene's own.
OracleRun oracle_run(const Scene& scene, const Push& push);

/// The results of the library and the oracle for one scene. Fast impacts are those faster than
/// `counting_limit`; under the rule of peaks the maxima that count take their place.
struct Comparison {
  bool compared = true;    ///< false if the oracle stopped at its cap
  bool certain = false;    ///< whether the library calls its count certain
  int count = 0;           ///< of the library
  int true_values = 0;     ///< of the oracle
  bool endless = false;    ///< whether the oracle says that there is no finite count
  int missed = 0;          ///< fast impacts of the oracle without a partner in the library
  int spurious = 0;        ///< fast impacts of the library without a partner in the oracle
  int matched = 0;         ///< pairs of fast impacts
  double time_error = 0;   ///< [s], largest difference over the pairs
  double speed_error = 0;  ///< [m/s], largest difference over the pairs

  bool agrees() const { return !endless && count == true_values; }
};

/// Simulates a valid scene of fidelity impact with both. The k-th fast impacts of both are partners
/// if they are on the same wall.
Comparison compare(const Scene& scene);

}  // namespace ricochet::carrier_track::inline oracle
