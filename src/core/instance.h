#pragma once

#include "ricochet/problem.h"
#include "ricochet/random.h"

namespace ricochet {

/// The same problem in other coordinates and in another box, with the same best value. An advantage
/// of a solver from the origin, the middle or the ends of the box, or the start, is chance and
/// shows as spread over instances:
/// - The best point lies elsewhere in the box. The box shrinks to 0.5 to 1 of its width in every
///   coordinate and stays within the old one. If the problem is defined outside, too, the box keeps
///   its width, and the best point lies anywhere in its inner four fifths. A best point at an end
///   of the box stays there, unless the problem mirrors: then the box holds a part of the mirror
///   image, too, and the best point lies in its inner four fifths. If no best point is known, the
///   box does not change.
/// - Every coordinate is moved by up to the box's width and, with probability 1/2, reflected.
/// - A problem that allows it is rotated about its best point, so that the axes give no advantage.
/// - The start is drawn uniformly from the box, or is the image of the published one, which the box
///   then contains.
///
/// Instance 0 is the problem as stated. Deterministic in (problem name, number). Throws
/// std::invalid_argument for number < 0.
Problem instance(const Problem& problem, int number);

/// The point of the problem as stated that x is in the instance with this number >= 0. In the box,
/// unless the problem rotates.
Vector stated_point(const Problem& problem, int number, const Vector& x);

/// The number of coordinates of the best point that are at an end of the box, to a millionth of its
/// width, in every instance. 0 if no best point is known.
Eigen::Index coordinates_at_ends(const Problem& problem);

/// A point uniform in the problem's box.
Vector uniform_point(const Problem& problem, Random& random);

}  // namespace ricochet
