#pragma once

#include <cstddef>
#include <vector>

#include "src/statistics/interval.h"

namespace ricochet {

/// One response (a share solved, a logarithm of evaluations, a regret) at one level of each factor.
struct Response {
  std::vector<std::size_t> levels;  ///< of each factor, from 0
  std::size_t unit;                 ///< the question or machine; those of one unit belong together
  double value;
};

/// What levels do to the response, in its unit.
struct FactorialEffect {
  std::vector<std::size_t> factors;  ///< none: the mean; one: a main effect; two: an interaction
  std::vector<std::size_t> levels;   ///< of these factors
  double effect;
  Interval interval;
};

/// The mean of all cells, the main effects and the interactions of every two factors, with
/// `levels_of_factors` >= 2 levels each: the mean of the cell {i, j} is mean + effect(i) +
/// effect(j)
/// + effect(i, j), where effects sum to 0 over each factor's levels. By least squares with
/// sum-to-zero coding, interactions of three factors being taken for 0, so that the grid may be
/// unbalanced; of two levels an effect is half of the difference that Box, Hunter and Hunter call
/// so. The interval is for units drawn from many: an effect's standard error is the jackknife's,
/// each unit left out in turn with all its responses, and the quantile is Student's with one degree
/// of freedom fewer than units (CV3 of MacKinnon, Nielsen and Webb 2023, doi:10.1002/jae.2969).
/// Where each unit has every cell once this is Student's interval of the effects within units.
/// Simulated, 95 % are 92 to 98 % with 8 units or more. Throws std::invalid_argument for responses
/// that do not fit, or from which effects do not follow, even without one of the units: every pair
/// of levels of two factors must be seen in two of them.
std::vector<FactorialEffect> factorial_effects(const std::vector<Response>& responses,
                                               const std::vector<std::size_t>& levels_of_factors,
                                               double confidence = 0.95);

}  // namespace ricochet
