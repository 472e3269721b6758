#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace ricochet {

/// The order of solvers on one question, the best first; those that are tied stand together, those
/// that did not take part nowhere.
using Ranking = std::vector<std::vector<std::size_t>>;

/// What a solver reached on a question, and at what cost: less is better, the value first. Infinite
/// where it reached nothing.
struct Reached {
  double value, cost;
};

/// The ranking of solvers 0, 1, ... by what they reached; nothing where one did not take part.
/// Throws std::invalid_argument for a value that is no number.
Ranking ranking_of(const std::vector<std::optional<Reached>>& reached);

}  // namespace ricochet
