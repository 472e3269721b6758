#pragma once

#include "src/core/problem.h"

namespace ricochet::contest {

/// Where in its box the best point of a problem lies, in every coordinate.
enum class Place { lower_end, middle, upper_end };

/// Whether there are such twins of a problem: its best point is known, and at no end of its box.
bool has_twins(const Problem& problem);

/// The same problem in the largest part of its box in which the best point lies at this place, with
/// start `number` of those drawn uniformly. What differs between twins is a solver's leaning to the
/// ends or to the middle.
Problem twin(Problem problem, Place place, int number);

}  // namespace ricochet::contest
