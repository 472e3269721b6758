#include "problems/carrier_track/problems/profile.h"

#include <fmt/format.h>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/counting/wear.h"
#include "problems/carrier_track/gradients/surrogate.h"
#include "problems/carrier_track/problems/best_known.h"
#include "problems/carrier_track/problems/problem_from_function.h"
#include "problems/carrier_track/scene/lifted.h"

namespace ricochet::carrier_track::inline problems {
namespace {

/// The bounds of a shape's factors.
constexpr double least_factor = 0.5;
constexpr double greatest_factor = 2.0;

struct ObjectiveOfShape {
  static constexpr int jet_size = 16;

  Scene scene;
  ProfileFrame frame;
  double smoothing;

  template <class Scalar, class Watch>
  Scalar operator()(std::span<const Scalar> x, Watch& watch) const {
    const BasicScene<Scalar> shaped = with_profile(lifted<Scalar>(scene), frame, x);
    auto watching = watch.of(shaped);
    return objective(shaped, smoothing, watching);
  }
};

struct WearOfShape {
  static constexpr int jet_size = 16;

  Scene scene;
  ProfileFrame frame;

  template <class Scalar, class Watch>
  Scalar operator()(std::span<const Scalar> x, Watch& watch) const {
    const BasicScene<Scalar> shaped = with_profile(lifted<Scalar>(scene), frame, x);
    auto watching = watch.of(shaped);
    return wear(shaped, watching);
  }
};

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
    define(problem, ObjectiveOfShape{scene, frame, smoothing},
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
  define(problem, WearOfShape{machine.scene, profile_frame(machine)},
         carries_derivatives(machine.scene));
  problem.tolerance = 0.01;
  return problem;
}

}  // namespace ricochet::carrier_track::inline problems
