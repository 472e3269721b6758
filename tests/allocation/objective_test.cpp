#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/gradients/shape_derivatives.h"
#include "problems/carrier_track/scene/scene_fields.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "tests/allocation/allocations.h"
#include "tests/support/problems.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

/// Calls of operator new that `work` makes.
template <class Work>
std::int64_t allocations_of(const Work& work) {
  const std::int64_t before = allocations();
  work();
  return allocations() - before;
}

/// Calls `look` with every case of the paper at several speeds. Expects a sum of its results above
/// 0 for every case.
template <class Look>
void for_each_case(const Look& look) {
  for (const Case& a_case : all_cases()) {
    double sum = 0;
    for (const double omega : {0.7, 1.9, 3.0, 5.8, 9.0, 12.0, 17.5}) {
      SCOPED_TRACE(a_case.id + " at " + std::to_string(omega));
      const Scene scene = at_speed(scene_of(a_case, exploratory_scene()), omega);
      sum += static_cast<double>(look(scene));
    }
    EXPECT_GT(sum, 0) << a_case.id;
  }
}

/// A run up to the scene's speed, at which it stays.
void run_up(Scene& scene) {
  scene.profile = {{0.0, 0.5 * scene.omega}, {0.2, 1.2 * scene.omega}, {0.3, scene.omega}};
}

/// That neither the count nor its surrogate allocates in the cases as `change` makes them, at a
/// constant speed and in a run up to it. Cases without events would prove nothing.
template <class Change>
void expect_no_allocation(const Change& change) {
  for (const bool runs_up : {false, true}) {
    for_each_case([&](Scene scene) {
      change(scene);
      if (runs_up) run_up(scene);
      double count = 0;
      EXPECT_EQ(allocations_of([&] { count = objective(scene, 0.0); }), 0);
      EXPECT_EQ(allocations_of([&] { objective(scene, 0.25); }), 0);
      return count;
    });
  }
}

// NOTE: calls of the operators by name, because a compiler may leave out a new-expression.
TEST(Allocations, CountEveryFormulationOfNew) {
  static constexpr std::align_val_t wide{64};
  for (void (*const once)() : {
           +[] { ::operator delete(::operator new(8)); },
           +[] { ::operator delete[](::operator new[](8)); },
           +[] { ::operator delete(::operator new(8, std::nothrow)); },
           +[] { ::operator delete[](::operator new[](8, std::nothrow)); },
           +[] { ::operator delete(::operator new(8, wide), wide); },
           +[] { ::operator delete[](::operator new[](8, wide), wide); },
           +[] { ::operator delete(::operator new(8, wide, std::nothrow), wide); },
           +[] { ::operator delete[](::operator new[](8, wide, std::nothrow), wide); },
       }) {
    EXPECT_EQ(allocations_of(once), 1);
  }
}

TEST(Objective, DoesNotAllocateBetweenHardWalls) {
  expect_no_allocation([](Scene&) {});
}

TEST(Objective, DoesNotAllocateWherePeaksCount) {
  expect_no_allocation([](Scene& scene) {
    scene.rule = CountRule::peaks;
    scene.peak_low = scene.wall_upper;
  });
}

/// With the same clearance across.
TEST(Objective, DoesNotAllocateInTwoDirections) {
  expect_no_allocation([](Scene& s) {
    s.fidelity = Fidelity::planar;
    s.across =
        Across<double>{0.5 * s.pull,        s.wall_lower,     s.wall_upper, s.restitution_lower,
                       s.restitution_upper, s.start_position, 0.05};
  });
}

class CompliantObjective : public testing::TestWithParam<std::pair<std::string_view, ContactLaw>> {
};

TEST_P(CompliantObjective, DoesNotAllocate) {
  expect_no_allocation([](Scene& scene) {
    scene.fidelity = Fidelity::compliant;
    scene.contact_law = GetParam().second;
    if (scene.contact_law == ContactLaw::kelvin_voigt) scene.contact_exponent = 1;
  });
}

INSTANTIATE_TEST_SUITE_P(Laws, CompliantObjective, testing::ValuesIn(contact_law_names()),
                         [](const auto& tested) {
                           return test_name(std::string(tested.param.first));
                         });

/// A profile is copied once, into dual numbers; nothing else allocates.
TEST(SurrogateSlope, AllocatesForACopyOfTheProfileAlone) {
  for_each_case([](Scene scene) {
    EXPECT_EQ(allocations_of([&] { surrogate_slope(scene, 0.25); }), 0);
    run_up(scene);
    const std::int64_t copy = allocations_of([&] { lifted<double>(scene); });
    EXPECT_EQ(allocations_of([&] { surrogate_slope(scene, 0.25); }), copy);
    return copy;
  });
}

}  // namespace
}  // namespace ricochet::carrier_track
