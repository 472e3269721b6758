#pragma once

#include <vector>

#include "problems/carrier_track/check/oracle/oracle.h"
#include "problems/carrier_track/counting/recording.h"
#include "ricochet/recording.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline oracle {

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

/// The impacts of a list that are faster than `counting_limit` [m/s].
std::vector<Impact> faster(const std::vector<Impact>& impacts, double counting_limit);

/// The maxima of a list that count under the scene's rule of peaks.
std::vector<Peak> counted(const std::vector<Peak>& maxima, const Scene& scene);

}  // namespace ricochet::carrier_track::inline oracle
