#pragma once

#include "src/benchmark/experiment/perturbations/perturbation.h"

namespace ricochet {

/// The variables, with their names, are permuted by a random cyclic permutation: no variable keeps
/// its place, and all such permutations are equally likely (Sattolo, Information Processing Letters
/// 22 (1986) 315, doi 10.1016/0020-0190(86)90073-6). For two variables or more.
Perturbation permuted();

/// Each variable is replaced by its negative with probability 1/2, and at least one is. The values
/// of the problem keep every bit.
Perturbation reflected();

/// The problem is rotated about its best point by a uniformly random orthogonal matrix. The box
/// stays the same, except that it grows if needed to contain the start; the variables are mixed now
/// and have no names. For problems that may be rotated, see Problem::rotates, with two variables or
/// more.
Perturbation rotated();

}  // namespace ricochet
