#pragma once

#include <optional>
#include <vector>

namespace ricochet {

/// What a run spent until it reached the target, or in all if it did not.
struct Effort {
  double spent;  ///< evaluations or seconds, >= 0
  bool reached;
};

/// Expected effort to reach the target with independent restarts: the effort of all runs, each
/// failed one at its own length, over the number of successes (Hansen et al. 2021,
/// doi:10.1080/10556788.2020.1808977). Nothing where no run reached it.
std::optional<double> expected_running_time(const std::vector<Effort>& runs);

}  // namespace ricochet
