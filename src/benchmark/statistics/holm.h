#pragma once

#include <vector>

namespace ricochet {

/// p-values of a family of tests, adjusted so that the probability of rejecting any true hypothesis
/// stays below the level, whatever the dependence between the tests (Holm 1979, Scandinavian
/// Journal of Statistics 6, 65, https://www.jstor.org/stable/4615733). In the order given. Throws
/// std::invalid_argument for a value outside [0, 1].
std::vector<double> holm(const std::vector<double>& p_values);

}  // namespace ricochet
