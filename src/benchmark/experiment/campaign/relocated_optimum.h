#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ricochet/problem.h"

namespace ricochet {

/// The place of the best point of a relocated-optimum variant in its box, the same in every
/// coordinate.
enum class OptimumPlace { lower_end, middle, upper_end };

/// The perturbation names of the variants' cells, in the order of the places:
/// "optimum-at-lower-end", "optimum-in-middle", "optimum-at-upper-end".
const std::vector<std::string>& names_of_places();

/// The place named by the perturbation; nothing for another perturbation.
std::optional<OptimumPlace> place_named(const std::string& perturbation);

/// Returns true if the best point is known and in no coordinate at an end of the box.
bool can_be_relocated(const Problem& problem);

/// The same problem in the largest part of its box in which the best point has this place, with
/// start number `number` of those drawn uniformly. A solver whose success rate differs between the
/// variants prefers the ends or the middle of a box.
Problem relocated(Problem problem, OptimumPlace place, int number);

}  // namespace ricochet
