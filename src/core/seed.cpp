#include <algorithm>
#include <cmath>
#include <string>

#include "ricochet/random.h"
#include "src/core/instance.h"

namespace ricochet {

std::uint64_t seed_of(std::string_view problem, std::string_view solver, int instance, int run,
                      std::string_view shown) {
  FnvHash hash;
  const auto add = [&hash](std::string_view text) {
    hash.add(text);
    hash.add("\xFF");
  };
  add(problem);
  add(solver);
  add(std::to_string(instance));
  add(std::to_string(run));
  if (!shown.empty()) add(shown);
  return hash.value();
}

double uniform(Random& random) {
  constexpr double below_one = 1 - 0x1p-53;  // 64 bits, rounded to 53, may be 1
  return std::min(static_cast<double>(random()) * 0x1p-64, below_one);
}

Vector uniform_point(const Vector& lower, const Vector& upper, Random& random) {
  Vector x(lower.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    x[i] = uniform(random) * (upper[i] - lower[i]) + lower[i];
  }
  return x;
}

Vector normal(Eigen::Index size, Random& random) {
  Vector drawn(size);
  for (Eigen::Index k = 0; k < size; k += 2) {
    double x = 0, y = 0, square = 0;
    do {
      x = 2 * uniform(random) - 1;
      y = 2 * uniform(random) - 1;
      square = x * x + y * y;
    } while (square > 1 || square == 0);
    const double stretch = std::sqrt(-2 * std::log(square) / square);
    drawn[k] = y * stretch;
    if (k + 1 < size) drawn[k + 1] = x * stretch;
  }
  return drawn;
}

Matrix random_turn(Eigen::Index n, Random& random) {
  // Normal columns, orthogonalised one after the other, twice because of rounding.
  Matrix turn = normal(n * n, random).reshaped(n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    Vector column = turn.col(k);
    for (int pass = 0; pass < 2; ++pass) {
      for (Eigen::Index j = 0; j < k; ++j) column -= turn.col(j).dot(column) * turn.col(j);
    }
    turn.col(k) = column.normalized();
  }
  return turn;
}

}  // namespace ricochet
