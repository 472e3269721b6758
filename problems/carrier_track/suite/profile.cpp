#include "problems/carrier_track/suite/profile.h"

#include <fmt/format.h>

#include "problems/carrier_track/gradients/derivatives.h"
#include "problems/carrier_track/gradients/shape_derivatives.h"
#include "problems/carrier_track/suite/best_known.h"
#include "problems/carrier_track/suite/problem_from_function.h"

namespace ricochet::carrier_track::inline problems {

namespace {

/// The bounds of a shape's factors.
constexpr double least_factor = 0.5;
constexpr double greatest_factor = 2.0;

Scene shaped(const Scene& scene, const ProfileFrame& frame, const Vector& x) {
  return with_profile(scene, frame, std::span(x.data(), static_cast<std::size_t>(x.size())));
}

/// Sets the sum over the motion of the machine as objective, with derivatives if `derivatives`.
template <class EventSum>
void define(Problem& problem, const Scene& scene, const ProfileFrame& frame, const EventSum& of,
            bool derivatives) {
  problem.evaluate = [=](const Vector& x) {
    const Scene at = shaped(scene, frame, x);
    auto sum = of.over(at);
    simulate_at_needed_fidelity(at, sum);
    return Values{sum.total(), {}};
  };
  if (!derivatives) return;
  const Vector widths = problem.upper - problem.lower;
  problem.differentiate = [=](const Vector& x) {
    const Scene at = shaped(scene, frame, x);
    Gradient g = shape_gradient(of, at, shaped_knots(at, x), widths);
    return Derivatives{{g.value, {}}, std::move(g.gradient), Matrix(0, x.size()), g.trust};
  };
  problem.lagrangian_hessian = [=](const Vector& x, double objective_factor,
                                   const Vector& /*multipliers*/) -> Matrix {
    if (objective_factor == 0) return Matrix::Zero(x.size(), x.size());
    const Scene at = shaped(scene, frame, x);
    const Matrix curvature =
        shape_curvature(of, at, shaped_knots(at, x), Matrix::Identity(x.size(), x.size()));
    // Both halves have the same digits.
    return 0.5 * objective_factor * (curvature + curvature.transpose());
  };
}

/// The problem over the shape, without an objective yet. It starts from the steady speed.
Problem shape_problem(const std::string& family, const Machine& machine, std::size_t n,
                      std::string source) {
  const auto size = static_cast<Eigen::Index>(n);
  Problem problem;
  problem.name = fmt::format("{}-{}-{}", family, n, machine.id);
  problem.source = std::move(source);
  for (std::size_t k = 0; k < n; ++k) problem.variables.push_back({fmt::format("y{}", k), ""});
  problem.lower = Vector::Constant(size, least_factor);
  problem.upper = Vector::Constant(size, greatest_factor);
  problem.start = Vector::Ones(size);
  problem.machine = machine.id;
  problem.gradient_cost = profile_gradient_cost;
  know_best(problem, machine.default_hash);
  return problem;
}

}  // namespace

ShapedKnots shaped_knots(const Scene& scene, const Vector& shape) {
  Vector weights = Vector::Ones(shape.size());  // of the trapezoidal mean
  weights[0] = weights[shape.size() - 1] = 0.5;
  ShapedKnots knots{scene.profile.front().omega / shape[0], Vector(shape.size()),
                    weights / weights.dot(shape)};
  for (Eigen::Index k = 0; k < shape.size(); ++k) {
    knots.speeds[k] = scene.profile[static_cast<std::size_t>(k)].omega;
  }
  return knots;
}

Problem profile_count_problem(const Machine& machine, std::size_t n) {
  const auto define_at = [scene = machine.scene, frame = profile_frame(machine)](Problem& problem,
                                                                                 double smoothing) {
    define(problem, scene, frame, SurrogateSum{smoothing},
           smoothing > 0 && carries_derivatives(scene));
  };
  Problem frame = shape_problem("profile-count", machine, n, "collision count of a profile");
  frame.smoothing = default_smoothing;
  frame.tolerance = 0.5;  // the count must be exact
  return smoothable(frame, define_at);
}

Problem profile_wear_problem(const Machine& machine, std::size_t n) {
  Problem problem =
      shape_problem("profile-wear", machine, n, "energy that the impacts of a profile lose, mJ");
  define(problem, machine.scene, profile_frame(machine), WearSum(),
         carries_derivatives(machine.scene));
  problem.tolerance = 0.01;
  return problem;
}

}  // namespace ricochet::carrier_track::inline problems
