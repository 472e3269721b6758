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

/// What the two families share.
Family shape_family(std::string name) {
  Family family;
  family.name = std::move(name);
  family.asks =
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
    for (const std::size_t n : profile_sizes) family.questions.push_back(make(machine, n));
  }
}

}  // namespace

Question profile_count_question(const Machine& machine, std::size_t n) {
  const auto define_at = [scene = machine.scene, frame = profile_frame(machine)](Problem& problem,
                                                                                 double width) {
    define(problem, ObjectiveOfShape{scene, frame, width}, width > 0 && carries_derivatives(scene));
  };
  return {
      .stated = smoothable(
          shape_problem("profile-count", machine, n, "collision count of a profile"), define_at),
      .machine = machine.id,
      .width = default_width,
      .tolerance = 0.5};  // a count must be met
}

Question profile_wear_question(const Machine& machine, std::size_t n) {
  Problem problem =
      shape_problem("profile-wear", machine, n, "energy that the impacts of a profile lose, mJ");
  define(problem, WearOfShape{machine.scene, profile_frame(machine)},
         carries_derivatives(machine.scene));
  return {.stated = std::move(problem), .machine = machine.id, .tolerance = 0.01};
}

Family profile_count_family(const std::vector<Machine>& machines) {
  Family family = shape_family("profile-count");
  family.title = "The speed profile of the fewest collisions";
  family.formula += "Minimise the collision count.";
  family.surrogate = "The smooth surrogate of the count.";
  family.derivatives =
      "Exact, of the surrogate, by dual numbers carried through the simulation, to every knot. The "
      "plate's acceleration, which a constant speed does not have, enters the slider's force.";
  family.users =
      "A designer of a servo drive; whoever compares how solvers, with derivatives or without, "
      "bear many variables.";
  fill(family, machines, profile_count_question);
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
  fill(family, machines, profile_wear_question);
  return family;
}

}  // namespace ricochet::carrier_track::inline questions
