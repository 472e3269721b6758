#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace ricochet {

/// The order of solvers on one problem, the best first. Tied solvers are in one group; solvers that
/// did not take part are missing.
using Ranking = std::vector<std::vector<std::size_t>>;

/// The value that a solver reached on a problem, and its cost: less is better, the value compared
/// first. Infinite if it reached nothing.
struct Reached {
  double value, cost;
};

/// The ranking of solvers 0, 1, ... by what they reached; an entry without value did not take part.
/// Throws std::invalid_argument for a value that is no number.
Ranking ranking_of(const std::vector<std::optional<Reached>>& reached);

}  // namespace ricochet
