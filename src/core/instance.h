#pragma once

#include "src/core/problem.h"
#include "src/core/random.h"

namespace ricochet {

/// The same problem in other coordinates and in another box, with the same best value. What a
/// solver gains from the origin, the middle or the ends of the box, or from the start, is chance,
/// and shows as spread over instances:
/// - The best point lies elsewhere in the box. The box shrinks to 0.5 to 1 of its width in every
///   coordinate and stays within the old one; where the problem is defined outside, too, it keeps
///   its width, and the best point lies anywhere in its inner four fifths. The box stays as it is
///   where no best point is known.
/// - Every coordinate is moved by up to the box's width and, on the toss of a coin, reflected.
/// - A problem that allows it is turned about its best point: nothing is gained from the axes.
/// - The start is drawn uniformly from the box, or is the image of the published one, which the box
///   then holds.
/// Instance 0 is the problem as stated. Deterministic in (problem name, number).
/// Throws std::invalid_argument for number < 0.
Problem instance(const Problem& problem, int number);

/// A point uniform in the problem's box.
Vector uniform_point(const Problem& problem, Random& random);

}  // namespace ricochet
