#pragma once

#include <cstdint>
#include <random>

#include "src/core/vector.h"

/// Random numbers from a generator's bits alone: the same with every standard library, which the
/// distributions of <random> are not.
namespace ricochet {

using Random = std::mt19937_64;

/// Uniform in [0, 1).
double uniform(Random& random);

/// `size` independent numbers of mean 0 and deviation 1, by Marsaglia's polar method (Marsaglia and
/// Bray, SIAM Review 6 (1964) 260, doi 10.1137/1006063).
Vector normal(Eigen::Index size, Random& random);

/// A random orthogonal matrix, of the uniform (Haar) distribution.
Matrix random_turn(Eigen::Index n, Random& random);

}  // namespace ricochet
