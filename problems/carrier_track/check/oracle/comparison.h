#pragma once

#include <vector>

#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/oracle/oracle.h"
#include "problems/carrier_track/scene/scene.h"

namespace ricochet::carrier_track::inline oracle {

/// What the library and the oracle make of one scene. Fast impacts are those faster than `slowest`;
/// under the rule of peaks the maxima that count take their place.
struct Comparison {
  bool compared = true;    ///< false where the oracle broke off, at its cap
  bool certain = false;    ///< whether the library calls its count certain
  int count = 0;           ///< of the library
  int truth = 0;           ///< of the oracle
  bool endless = false;    ///< whether the oracle says that there is no count: it has no end
  int missed = 0;          ///< fast impacts of the oracle without a partner in the library
  int spurious = 0;        ///< fast impacts of the library without a partner in the oracle
  int matched = 0;         ///< pairs of fast impacts
  double time_error = 0;   ///< [s], largest difference over the pairs
  double speed_error = 0;  ///< [m/s], largest difference over the pairs

  bool agrees() const { return !endless && count == truth; }
};

/// Simulates a valid scene of fidelity impact twice. The k-th fast impact of one is the partner of
/// the k-th of the other if it is on the same wall.
Comparison compare(const Scene& scene);

/// The impacts of a list faster than `slowest` [m/s].
std::vector<Impact> faster(const std::vector<Impact>& impacts, double slowest);

/// The maxima of a list that count under the rule of peaks of a scene.
std::vector<Peak> counted(const std::vector<Peak>& maxima, const Scene& scene);

}  // namespace ricochet::carrier_track::inline oracle
