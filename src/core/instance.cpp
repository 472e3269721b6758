#include "src/core/instance.h"

#include <memory>
#include <stdexcept>

#include "src/core/seed.h"

namespace ricochet {
namespace {

/// solver's x = offset + direction * natural x, coordinate by coordinate; direction is +1 or -1.
/// Before that the natural x may be turned about a centre.
struct Frame {
  Vector offset;
  Vector direction;
  bool turns;
  Matrix turn;  // orthogonal
  Vector centre;

  Vector natural(const Vector& x) const {
    const Vector straight = direction.cwiseProduct(x - offset);
    return turns ? Vector(centre + turn * (straight - centre)) : straight;
  }
  Vector shown(const Vector& x) const { return offset + direction.cwiseProduct(x); }

  /// d natural / d x.
  Matrix slope() const {
    return turns ? Matrix(turn * direction.asDiagonal()) : Matrix(direction.asDiagonal());
  }
};

/// A random orthogonal matrix, of the uniform (Haar) distribution: normal columns, made orthogonal
/// one after the other, twice for the sake of rounding.
Matrix random_turn(Eigen::Index n, Random& random) {
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

}  // namespace

Vector uniform_point(const Problem& problem, Random& random) {
  Vector x(problem.dimension());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    x[i] = uniform(random) * (problem.upper[i] - problem.lower[i]) + problem.lower[i];
  }
  return x;
}

Problem instance(const Problem& problem, int number) {
  if (number < 0) throw std::invalid_argument("instance: the number must be >= 0");
  if (number == 0) return problem;
  Random random(seed_of(problem.name, "instance", number, 0));
  const Vector width = problem.upper - problem.lower;
  const Eigen::Index n = problem.dimension();
  Frame frame{Vector(n), Vector(n), problem.rotates && n > 1, Matrix(), Vector()};
  for (Eigen::Index i = 0; i < problem.dimension(); ++i) {
    const bool reflected = uniform(random) < 0.5;
    const double shift = width[i] * (2 * uniform(random) - 1);
    frame.direction[i] = reflected ? -1.0 : 1.0;
    frame.offset[i] = (reflected ? problem.lower[i] + problem.upper[i] : 0.0) + shift;
  }
  if (frame.turns) {
    frame.turn = random_turn(n, random);
    frame.centre = problem.best_point.value();
  }
  const auto original = std::make_shared<const Problem>(problem);
  Problem result = problem;
  result.instance = number;
  const Vector a = frame.shown(problem.lower);
  const Vector b = frame.shown(problem.upper);
  result.lower = a.cwiseMin(b);
  result.upper = a.cwiseMax(b);
  result.start = uniform_point(result, random);
  if (problem.best_point) result.best_point = frame.shown(*problem.best_point);
  // NOTE: rounding in the frame can lead a hair outside the box; the original is asked inside it.
  // One that is turned is defined outside, too.
  const auto inside = [original, frame](const Vector& x) -> Vector {
    const Vector natural = frame.natural(x);
    return frame.turns ? natural : natural.cwiseMax(original->lower).cwiseMin(original->upper);
  };
  const Matrix slope = frame.slope();
  result.evaluate = [original, inside](const Vector& x) { return original->evaluate(inside(x)); };
  if (problem.differentiate) {
    result.differentiate = [original, inside, slope](const Vector& x) {
      Derivatives d = original->differentiate(inside(x));
      d.gradient = slope.transpose() * d.gradient;
      d.jacobian = d.jacobian * slope;
      return d;
    };
  }
  if (problem.residuals) {
    result.residuals = [original, inside, slope](const Vector& x) {
      Residuals r = original->residuals(inside(x));
      r.jacobian = r.jacobian * slope;
      return r;
    };
  }
  if (problem.truth) {
    result.truth = [original, inside](const Vector& x) { return original->truth(inside(x)); };
  }
  if (problem.smoothed) {
    result.smoothed = [original, number](double smoothing) {
      return instance(original->smoothed(smoothing), number);
    };
  }
  return result;
}

}  // namespace ricochet
