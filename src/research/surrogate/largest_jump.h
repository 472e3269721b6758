#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace ricochet::studies::surrogate {

/// A piece of [0, 1] and how much a function changes over it.
struct Piece {
  double lower, upper;
  double at_lower, at_upper;

  double change() const { return std::abs(at_upper - at_lower); }
};

/// Returns the piece with the largest change, of the even pieces of [0, 1] between the values of a
/// function at their ends; at least two values.
inline Piece steepest_piece(const std::vector<double>& values) {
  const double pieces = static_cast<double>(values.size() - 1);
  Piece steepest{0, 0, values[0], values[0]};
  for (std::size_t k = 1; k < values.size(); ++k) {
    const double end = static_cast<double>(k);
    const Piece piece{(end - 1) / pieces, end / pieces, values[k - 1], values[k]};
    if (k == 1 || piece.change() > steepest.change()) steepest = piece;
  }
  return steepest;
}

/// Returns two neighbouring numbers of a piece, by bisection that always takes the half where f
/// changes more.
template <class Function>
Piece narrowed(Piece piece, const Function& f) {
  for (;;) {
    const double middle = piece.lower + (piece.upper - piece.lower) / 2;
    if (!(middle > piece.lower && middle < piece.upper)) return piece;
    const double now = f(middle);
    if (std::abs(now - piece.at_lower) > std::abs(piece.at_upper - now)) {
      piece.upper = middle;
      piece.at_upper = now;
    } else {
      piece.lower = middle;
      piece.at_lower = now;
    }
  }
}

/// Returns the change of f between two neighbouring numbers, found from the largest of its changes
/// over 16 pieces of [0, 1].
template <class Function>
double largest_jump(const Function& f) {
  constexpr int pieces = 16;
  std::vector<double> values;
  for (int k = 0; k <= pieces; ++k) values.push_back(f(static_cast<double>(k) / pieces));
  return narrowed(steepest_piece(values), f).change();
}

}  // namespace ricochet::studies::surrogate
