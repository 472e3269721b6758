#pragma once

#include <cstddef>
#include <vector>

namespace ricochet {

/// A point with two values to be minimised; infinite values are allowed.
struct CostAndError {
  double cost, error;
};

/// Indices of the Pareto front: the points that no other point dominates, by rising cost; all of
/// several equal points. Throws std::invalid_argument for a value that is no number.
std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& points);

}  // namespace ricochet
