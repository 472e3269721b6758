// The problem that CONTRIBUTING.md shows how to add, with its test.

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "problems/carrier_track/suite/machine.h"
#include "problems/carrier_track/suite/problem_from_function.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "tests/carrier_track/gradients/differences.h"
#include "tests/support/scenes.h"

namespace ricochet::carrier_track {

Problem gentle_problem(const Machine& machine);

namespace {

/// The wear [mJ] at the speed x[0].
struct WearAtSpeed {
  static constexpr int jet_size = 1;

  Scene scene;

  template <class Scalar, class Watch>
  Scalar operator()(std::span<const Scalar> x, Watch& watch) const {
    const BasicScene<Scalar> at = at_speed(lifted<Scalar>(scene), x[0]);
    auto watching = watch.of(at);
    return wear(at, watching);
  }
};

}  // namespace

Problem gentle_problem(const Machine& machine) {
  Problem problem = speed_problem("gentle", machine, "energy that the impacts lose, mJ");
  define(problem, WearAtSpeed{machine.scene}, carries_derivatives(machine.scene));
  return problem;
}

TEST(ExampleProblem, HasDerivatives) {
  const Problem problem = gentle_problem(machine_of(find_case("C1"), exploratory_scene()));
  EXPECT_EQ(problem.name, "gentle-C1");
  expect_derivatives_of_values(problem, Vector::Constant(1, 4.321), 1e-7, 1e-6);
}

}  // namespace ricochet::carrier_track
