#include "problems/carrier_track/questions/profile.h"

#include <fmt/format.h>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/counting/wear.h"
#include "problems/carrier_track/gradients/surrogate.h"
#include "problems/carrier_track/questions/best_known.h"
#include "problems/carrier_track/questions/problem_from_function.h"

namespace ricochet::carrier_track::inline questions {
namespace {

/// The bounds of a shape's factors.
constexpr double least_factor = 0.5;
constexpr double greatest_factor = 2.0;

struct ObjectiveOfShape {
  static constexpr int jet_size = 16;

  Scene scene;
  ProfileFrame frame;
  double width;

  template <class Scalar, class Watch>
  Scalar operator()(std::span<const Scalar> x, Watch& watch) const {
    const BasicScene<Scalar> shaped = with_profile(lifted<Scalar>(scene), frame, x);
    auto watching = watch.of(shaped);
    return objective(shaped, width, watching);
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

/// Over the shape, still without an objective. It starts from the steady speed.
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
  know_best(problem, machine.reading);
  return problem;
}

/// What the three families share.
Family shape_family(std::string name) {
  Family family;
  family.name = std::move(name);
  family.judged_as = family.name;
  family.question =
      "At a given mean speed, how should the speed vary during a turn so that the carrier hits its "
      "track least?";
  family.formula =
      "A profile has n knots, evenly spaced over a window of fixed length; the variables are n "
      "factors y within 0.5 to 2, and the speed at knot k is the mean speed times y_k over the "
      "trapezoidal mean of y, linear in between. So the mean speed, 1.25 times the threshold that "
      "the paper claims, or 6 rad/s where it claims none, holds for every y and needs no "
      "constraint; a common factor of all y changes nothing. ";
  family.instances =
      "n = 2, 4, 8, 16, 32 and 64 for each machine: the same question at six dimensions.";
  return family;
}

template <class Make>
void fill(Family& family, const std::vector<Machine>& machines, Make make) {
  for (const Machine& machine : machines) {
    for (const std::size_t n : profile_sizes) family.problems.push_back(make(machine, n));
  }
}

}  // namespace

Problem profile_count_problem(const Machine& machine, std::size_t n) {
  Problem problem = shape_problem("profile-count", machine, n, "collision count of a profile");
  define(problem, ObjectiveOfShape{machine.scene, profile_frame(machine), 0.0}, false);
  return problem;
}

Problem profile_problem(const Machine& machine, std::size_t n, double width) {
  Problem problem = judged_as_it_is(profile_count_problem(machine, n));
  problem.name = fmt::format("profile-{}-{}", n, machine.id);
  problem.source = "smooth surrogate of the collision count of a profile";
  define(problem, ObjectiveOfShape{machine.scene, profile_frame(machine), width},
         carries_derivatives(machine.scene));
  problem.smoothed = [machine, n](double other) { return profile_problem(machine, n, other); };
  return problem;
}

Problem profile_wear_problem(const Machine& machine, std::size_t n) {
  Problem problem =
      shape_problem("profile-wear", machine, n, "energy that the impacts of a profile lose, mJ");
  define(problem, WearOfShape{machine.scene, profile_frame(machine)},
         carries_derivatives(machine.scene));
  return problem;
}

Family profile_count_family(const std::vector<Machine>& machines) {
  Family family = shape_family("profile-count");
  family.title = "The speed profile of the fewest collisions, shown the count";
  family.formula += "Minimise the collision count.";
  family.users = "Whoever compares how solvers without derivatives bear many variables.";
  fill(family, machines, profile_count_problem);
  return family;
}

Family profile_family(const std::vector<Machine>& machines) {
  Family family = shape_family("profile");
  family.judged_as = "profile-count";
  family.title = "The speed profile of the fewest collisions, shown the surrogate";
  family.formula += "Minimise the smooth surrogate of the count; judged by the true count.";
  family.derivatives =
      "Exact, by dual numbers carried through the simulation, to every knot. The plate's "
      "acceleration, which a constant speed does not have, enters the slider's force.";
  family.users =
      "A designer of a servo drive; whoever compares how solvers with derivatives bear many "
      "variables.";
  fill(family, machines, [](const Machine& machine, std::size_t n) {
    return profile_problem(machine, n, default_width);
  });
  return family;
}

Family profile_wear_family(const std::vector<Machine>& machines) {
  Family family = shape_family("profile-wear");
  family.title = "The speed profile of the least wear";
  family.formula +=
      "Minimise the wear, the sum over all impacts of the kinetic energy that they lose, "
      "mass (1 - restitution^2) v^2 / 2, in mJ. It is smooth where the count jumps, because an "
      "impact is born with no speed; only where one leaves by the end of the window does it jump.";
  family.derivatives = "Exact, by dual numbers carried through the simulation; no smoothing.";
  family.users =
      "A designer whose track wears out rather than makes noise; whoever wants a smooth, "
      "multimodal, simulated objective that scales.";
  fill(family, machines, profile_wear_problem);
  return family;
}

}  // namespace ricochet::carrier_track::inline questions
