#pragma once

#include <cstddef>
#include <vector>

namespace ricochet {

/// Less of either is better; infinite allowed.
struct CostAndError {
  double cost, error;
};

/// The points than which no other is as good in both and better in one, by rising cost; of equal
/// points all. Throws std::invalid_argument for a value that is no number.
std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& points);

}  // namespace ricochet
