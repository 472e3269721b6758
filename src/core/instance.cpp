#include "src/core/instance.h"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>

#include "src/core/names.h"

namespace ricochet {

namespace {

/// A box in coordinates that are rotated, but not yet moved or reflected.
struct Box {
  Vector lower, upper;

  void hold(const Vector& x) {
    lower = lower.cwiseMin(x);
    upper = upper.cwiseMax(x);
  }
};

/// solver's x = offset + direction * straight x, coordinate by coordinate; direction is +1 or -1.
/// The straight x is the natural x, rotated about the centre if `turns`.
struct Frame {
  Vector offset;
  Vector direction;
  bool turns;
  Matrix turn;  // orthogonal
  Vector centre;

  Vector natural(const Vector& x) const {
    Vector straight = direction.cwiseProduct(x - offset);
    if (turns) straight = centre + turn * (straight - centre);
    return straight;
  }
  Vector straight(const Vector& natural) const {
    return turns ? Vector(centre + turn.transpose() * (natural - centre)) : natural;
  }
  Vector shown(const Vector& straight) const { return offset + direction.cwiseProduct(straight); }

  /// d natural / d x.
  Matrix slope() const {
    return turns ? Matrix(turn * direction.asDiagonal()) : Matrix(direction.asDiagonal());
  }
};

/// Whether a coordinate of the best point, which is known, is at an end of the box.
bool is_at_end(const Problem& problem, Eigen::Index i) {
  const double close = 1e-6 * (problem.upper[i] - problem.lower[i]);
  const double best = (*problem.best_point)[i];
  return best - problem.lower[i] <= close || problem.upper[i] - best <= close;
}

/// Returns a box in which the best point has another relative position.
Box box_around_best(const Problem& problem, Random& random) {
  Box box{problem.lower, problem.upper};
  if (!problem.best_point) return box;
  const Vector& best = *problem.best_point;
  for (Eigen::Index i = 0; i < best.size(); ++i) {
    const double whole = problem.upper[i] - problem.lower[i];
    const double share = uniform(random);
    const double width = problem.rotates ? whole : (0.5 + 0.5 * uniform(random)) * whole;
    const bool goes_on = problem.rotates || (problem.mirrors && is_at_end(problem, i));
    // The lower end is drawn from [from, to].
    const double from =
        goes_on ? best[i] - 0.9 * width : std::max(problem.lower[i], best[i] - width);
    const double to = goes_on ? best[i] - 0.1 * width : std::min(problem.upper[i] - width, best[i]);
    box.lower[i] = std::min(from + share * (to - from), best[i]);  // despite rounding
    box.upper[i] = std::max(box.lower[i] + width, best[i]);
    if (goes_on) continue;
    box.lower[i] = std::max(box.lower[i], problem.lower[i]);
    box.upper[i] = std::min(box.upper[i], problem.upper[i]);
  }
  return box;
}

/// Leads a point outside the box onto it: to the point that it mirrors, or to the nearest one.
/// Rounding in a frame can lead slightly outside, too.
void lead_inside(const Problem& problem, Vector& x) {
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const double lower = problem.lower[i], upper = problem.upper[i];
    if (problem.mirrors && x[i] < lower) x[i] = 2 * lower - x[i];
    if (problem.mirrors && x[i] > upper) x[i] = 2 * upper - x[i];
    x[i] = std::clamp(x[i], lower, upper);
  }
}

/// The point of the problem as stated that x is in the frame.
Vector stated(const Problem& problem, const Frame& frame, const Vector& x) {
  Vector natural = frame.natural(x);
  if (!problem.rotates) lead_inside(problem, natural);  // else it is defined outside, too
  return natural;
}

/// The problem with its functions in the frame's coordinates, otherwise unchanged.
Problem seen_through(const Frame& frame, const Problem& problem) {
  const auto original = std::make_shared<const Problem>(problem);
  const auto inside = [original, frame](const Vector& x) -> Vector {
    return stated(*original, frame, x);
  };
  const auto slope_at = [original, frame, slope = frame.slope()](const Vector& x) -> Matrix {
    if (!original->mirrors) return slope;
    const Vector natural = frame.natural(x);
    Matrix result = slope;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const bool outside = natural[i] < original->lower[i] || natural[i] > original->upper[i];
      if (outside) result.row(i) = -result.row(i);
    }
    return result;
  };
  Problem result = problem;
  result.not_excluded = nullptr;  // it is in the natural coordinates
  result.evaluate = [original, inside](const Vector& x) { return original->evaluate(inside(x)); };
  if (problem.differentiate) {
    result.differentiate = [original, inside, slope_at](const Vector& x) {
      Derivatives d = original->differentiate(inside(x));
      const Matrix slope = slope_at(x);
      d.gradient = slope.transpose() * d.gradient;
      d.jacobian = d.jacobian * slope;
      return d;
    };
  }
  if (problem.lagrangian_hessian) {
    result.lagrangian_hessian = [original, inside, slope_at](const Vector& x,
                                                             double objective_factor,
                                                             const Vector& multipliers) -> Matrix {
      const Matrix slope = slope_at(x);
      const Matrix hessian = original->lagrangian_hessian(inside(x), objective_factor, multipliers);
      return slope.transpose() * hessian * slope;
    };
  }
  if (problem.residuals) {
    result.residuals = [original, inside, slope_at](const Vector& x) {
      Residuals r = original->residuals(inside(x));
      r.jacobian = r.jacobian * slope_at(x);
      return r;
    };
  }
  if (problem.residual_values) {
    result.residual_values = [original, inside](const Vector& x) {
      return original->residual_values(inside(x));
    };
  }
  if (problem.true_values) {
    result.true_values = [original, inside](const Vector& x) {
      return original->true_values(inside(x));
    };
  }
  return result;
}

/// Where an instance of a problem lies.
struct Placement {
  Frame frame;
  Box box;
  Vector start;  // straight; empty if it is drawn
};

Placement placement_of(const Problem& problem, int number, Random& random) {
  const Eigen::Index n = problem.dimension();
  Frame frame{Vector(n), Vector(n), problem.rotates && n > 1, Matrix(), Vector()};
  if (frame.turns) {
    frame.turn = random_turn(n, random);
    frame.centre = problem.best_point.value();
  }
  Box box = box_around_best(problem, random);
  Vector start;  // straight
  if (!problem.start_scales.empty()) {
    const auto k = static_cast<std::size_t>(number - 1) % problem.start_scales.size();
    start = frame.straight(problem.start_scales[k] * problem.start);
    if (!problem.rotates) start = start.cwiseMax(problem.lower).cwiseMin(problem.upper);
    box.hold(start);
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    const bool reflected = uniform(random) < 0.5;
    const double shift = (box.upper[i] - box.lower[i]) * (2 * uniform(random) - 1);
    frame.direction[i] = reflected ? -1.0 : 1.0;
    frame.offset[i] = (reflected ? box.lower[i] + box.upper[i] : 0.0) + shift;
  }
  return {frame, box, start};
}

}  // namespace

bool is_chosen(const Problem& problem, const std::vector<std::string>& patterns) {
  const std::string family = problem.name.substr(0, problem.name.find('-'));
  return std::ranges::any_of(patterns, [&](const std::string& pattern) {
    const bool by_name_alone = problem.hazardous || problem.held_out;
    return fits(problem.name, pattern) && (!by_name_alone || pattern.starts_with(family));
  });
}

Vector uniform_point(const Problem& problem, Random& random) {
  return uniform_point(problem.lower, problem.upper, random);
}

Vector stated_point(const Problem& problem, int number, const Vector& x) {
  if (number == 0) return x;
  Random random(seed_of(problem.name, "instance", number, 0));
  return stated(problem, placement_of(problem, number, random).frame, x);
}

Problem instance(const Problem& problem, int number) {
  if (number < 0) throw std::invalid_argument("instance: the number must be >= 0");
  if (number == 0) return problem;
  Random random(seed_of(problem.name, "instance", number, 0));
  const auto [frame, box, start] = placement_of(problem, number, random);
  Problem result = seen_through(frame, problem);
  result.instance = number;
  const Vector a = frame.shown(box.lower);
  const Vector b = frame.shown(box.upper);
  result.lower = a.cwiseMin(b);
  result.upper = a.cwiseMax(b);
  result.start = start.size() > 0 ? frame.shown(start) : uniform_point(result, random);
  if (problem.best_point) result.best_point = frame.shown(*problem.best_point);
  if (problem.smoothed) {
    result.smoothed = [smoothed = problem.smoothed, number](double smoothing) {
      return instance(smoothed(smoothing), number);
    };
  }
  return result;
}

}  // namespace ricochet
