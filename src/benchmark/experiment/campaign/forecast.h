#pragma once

#include "src/benchmark/experiment/campaign/campaign.h"

namespace ricochet {

/// Estimated processor time [s] of a campaign that has no runs yet.
struct Forecast {
  double search = 0;      ///< for the best values that are not known
  double runs = 0;        ///< with starting their processes, programs and libraries
  double report = 0;      ///< for the numbers and the pages
  bool at_least = false;  ///< some solver could not be timed, and its own time is missing

  /// Elapsed time [s] on so many cores, if nothing else runs on them.
  double seconds(double cores) const;
};

/// Foretells from the time of evaluations in the box of every problem, and from two short runs of
/// every solver, which are made for this purpose. Too low if solvers become slower with the number
/// of variables or evaluations; too high if runs end before their budget is spent.
Forecast forecast_of(const Campaign& campaign);

}  // namespace ricochet
