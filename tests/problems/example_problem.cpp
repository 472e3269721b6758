#include "tests/problems/example_problem.h"

#include "problems/carrier_track/counting/wear.h"
#include "problems/carrier_track/questions/problem_from_function.h"
#include "problems/carrier_track/questions/speed_problem.h"

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

Family gentle_family(const std::vector<Machine>& machines) {
  Family family;
  family.name = "gentle";
  family.title = "The gentlest speed";
  family.asks = "At which speed do the impacts of a turn take the least energy?";
  family.formula = "Minimise the wear over the speed.";
  family.derivatives = "Exact, by dual numbers carried through the simulation.";
  family.instances = "One for each machine.";
  family.users = "A designer whose track wears out rather than makes noise.";
  for (const Machine& machine : machines) {
    Problem problem = speed_problem("gentle", machine, "energy that the impacts lose, mJ");
    define(problem, WearAtSpeed{machine.scene}, carries_derivatives(machine.scene));
    family.questions.push_back({.stated = problem, .machine = machine.id});
  }
  return family;
}

}  // namespace ricochet::carrier_track
