#include "src/core/instance.h"

#include <memory>
#include <stdexcept>

#include "src/core/seed.h"

namespace ricochet {
namespace {

/// solver's x = offset + direction * natural x, coordinate by coordinate; direction is +1 or -1.
struct Frame {
  Vector offset;
  Vector direction;

  Vector natural(const Vector& x) const { return direction.cwiseProduct(x - offset); }
  Vector shown(const Vector& x) const { return offset + direction.cwiseProduct(x); }
};

}  // namespace

Vector uniform_point(const Problem& problem, Random& random) {
  Vector x(problem.dimension());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    x[i] = std::uniform_real_distribution<double>(problem.lower[i], problem.upper[i])(random);
  }
  return x;
}

Problem instance(const Problem& problem, int number) {
  if (number < 0) throw std::invalid_argument("instance: the number must be >= 0");
  if (number == 0) return problem;
  Random random(seed_of(problem.name, "instance", number, 0));
  const Vector width = problem.upper - problem.lower;
  Frame frame{Vector(problem.dimension()), Vector(problem.dimension())};
  for (Eigen::Index i = 0; i < problem.dimension(); ++i) {
    const bool reflected = std::bernoulli_distribution(0.5)(random);
    const double shift = width[i] * std::uniform_real_distribution<double>(-1.0, 1.0)(random);
    frame.direction[i] = reflected ? -1.0 : 1.0;
    frame.offset[i] = (reflected ? problem.lower[i] + problem.upper[i] : 0.0) + shift;
  }
  const auto original = std::make_shared<const Problem>(problem);
  Problem result = problem;
  result.instance = number;
  const Vector a = frame.shown(problem.lower);
  const Vector b = frame.shown(problem.upper);
  result.lower = a.cwiseMin(b);
  result.upper = a.cwiseMax(b);
  result.start = uniform_point(result, random);
  // NOTE: rounding in the frame can lead a hair outside the box; the original is asked inside it.
  const auto inside = [original, frame](const Vector& x) -> Vector {
    return frame.natural(x).cwiseMax(original->lower).cwiseMin(original->upper);
  };
  result.evaluate = [original, inside](const Vector& x) { return original->evaluate(inside(x)); };
  if (problem.differentiate) {
    result.differentiate = [original, inside, frame](const Vector& x) {
      Derivatives d = original->differentiate(inside(x));
      d.gradient = d.gradient.cwiseProduct(frame.direction);
      d.jacobian = d.jacobian * frame.direction.asDiagonal();
      return d;
    };
  }
  if (problem.residuals) {
    result.residuals = [original, inside, frame](const Vector& x) {
      Residuals r = original->residuals(inside(x));
      r.jacobian = r.jacobian * frame.direction.asDiagonal();
      return r;
    };
  }
  if (problem.truth) {
    result.truth = [original, inside](const Vector& x) { return original->truth(inside(x)); };
  }
  return result;
}

}  // namespace ricochet
