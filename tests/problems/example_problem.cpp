#include "tests/problems/example_problem.h"

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "problems/carrier_track/suite/problem_from_function.h"
#include "problems/carrier_track/suite/speed_problems.h"

namespace ricochet::carrier_track {
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

}  // namespace ricochet::carrier_track
