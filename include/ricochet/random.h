#pragma once

#include <cstdint>
#include <random>

#include "ricochet/problem.h"

/// Random numbers computed from a generator's bits alone, so that every standard library gives the
/// same ones; its own distributions may differ.
namespace ricochet {

using Random = std::mt19937_64;

/// Uniform in [0, 1).
double uniform(Random& random);

/// A point uniform in the box; both ends have length n.
Vector uniform_point(const Vector& lower, const Vector& upper, Random& random);

/// `size` independent numbers of mean 0 and deviation 1, by Marsaglia's polar method (Marsaglia and
/// Bray, SIAM Review 6 (1964) 260, doi 10.1137/1006063).
Vector normal(Eigen::Index size, Random& random);

/// A random orthogonal matrix, of the uniform (Haar) distribution.
Matrix random_turn(Eigen::Index n, Random& random);

}  // namespace ricochet
