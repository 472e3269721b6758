#pragma once

#include <vector>

#include "ricochet/vector.h"

/// The directions of OrthoMADS: Abramson, Audet, Dennis and Le Digabel, SIAM J. Optim. 20 (2009)
/// 948-966, doi 10.1137/080716980.
namespace ricochet {

/// An orthogonal n x n matrix of integers: the Householder matrix |q|^2 I - 2 q q^T, where q is the
/// longest integer vector along `direction` (length n, not 0) with a norm of at most 2^(index / 2).
/// Its columns have the norm |q|^2, at most 2^index. index >= 0.
Matrix poll_basis(const Vector& direction, int index);

/// n + 1 directions that span the space positively. The first n are the columns of `basis`, each
/// with the sign that points along `leading`, sorted by how much they do; the last is the opposite
/// of their sum (Audet, Ianni, Le Digabel and Tribes, SIAM J. Optim. 24 (2014) 621-642, doi
/// 10.1137/120895056, without their quadratic models).
std::vector<Vector> poll_directions(const Matrix& basis, const Vector& leading);

}  // namespace ricochet
