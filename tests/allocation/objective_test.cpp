#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/gradients/shape_derivatives.h"
#include "problems/carrier_track/scene/scene_fields.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "problems/carrier_track/suite/machine.h"
#include "tests/allocation/allocations.h"
#include "tests/support/problems.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

constexpr double speeds[] = {0.7, 1.9, 3.0, 5.8, 9.0, 12.0, 17.5};  // [rad/s]

/// Calls of operator new that `work` makes.
template <class Work>
std::int64_t allocations_of(const Work& work) {
  const std::int64_t before = allocations();
  work();
  return allocations() - before;
}

/// That neither the count nor its surrogate allocates. Returns the count: a scene without events
/// would prove nothing.
double expect_no_allocation(const Scene& scene) {
  double count = 0;
  EXPECT_EQ(allocations_of([&] { count = objective(scene, 0.0); }), 0);
  EXPECT_EQ(allocations_of([&] { objective(scene, 0.25); }), 0);
  return count;
}

/// The same of every case of the paper at several speeds, as `change` makes them.
template <class Change>
void expect_no_allocation_in_cases(const Change& change) {
  for (const Case& a_case : all_cases()) {
    double counts = 0;
    for (const double omega : speeds) {
      SCOPED_TRACE(a_case.id + " at " + std::to_string(omega));
      Scene scene = at_speed(scene_of(a_case, exploratory_scene()), omega);
      change(scene);
      counts += expect_no_allocation(scene);
    }
    EXPECT_GT(counts, 0) << a_case.id;
  }
}

/// A run up to the scene's speed, at which it stays.
void run_up(Scene& scene) {
  scene.profile = {{0.0, 0.5 * scene.omega}, {0.2, 1.2 * scene.omega}, {0.3, scene.omega}};
}

/// The same clearance across.
void free_across(Scene& scene) {
  scene.fidelity = Fidelity::planar;
  scene.across = Across<double>{0.5 * scene.pull,
                                scene.wall_lower,
                                scene.wall_upper,
                                scene.restitution_lower,
                                scene.restitution_upper,
                                scene.start_position,
                                0.05};
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
  expect_no_allocation_in_cases([](Scene&) {});
  expect_no_allocation_in_cases(run_up);
}

TEST(Objective, DoesNotAllocateWherePeaksCount) {
  expect_no_allocation_in_cases([](Scene& scene) {
    scene.rule = CountRule::peaks;
    scene.peak_low = scene.wall_upper;
  });
}

TEST(Objective, DoesNotAllocateInTwoDirections) {
  expect_no_allocation_in_cases(free_across);
  expect_no_allocation_in_cases([](Scene& scene) {
    free_across(scene);
    run_up(scene);
  });
}

class CompliantObjective : public testing::TestWithParam<ContactLaw> {};

TEST_P(CompliantObjective, DoesNotAllocate) {
  const auto make_compliant = [](Scene& scene) {
    scene.fidelity = Fidelity::compliant;
    scene.contact_law = GetParam();
    if (GetParam() == ContactLaw::kelvin_voigt) scene.contact_exponent = 1;
  };
  expect_no_allocation_in_cases(make_compliant);
  expect_no_allocation_in_cases([&](Scene& scene) {
    make_compliant(scene);
    run_up(scene);
  });
}

INSTANTIATE_TEST_SUITE_P(Laws, CompliantObjective,
                         testing::Values(ContactLaw::hertz, ContactLaw::kelvin_voigt,
                                         ContactLaw::hunt_crossley, ContactLaw::lankarani_nikravesh,
                                         ContactLaw::zhiying_qishao, ContactLaw::flores,
                                         ContactLaw::gonthier, ContactLaw::exact_restitution),
                         [](const auto& tested) {
                           return test_name(
                               std::string(name_of(contact_law_names(), tested.param)));
                         });

/// A profile is copied once, into dual numbers; nothing else allocates.
TEST(SurrogateSlope, AllocatesForACopyOfTheProfileAlone) {
  for (const Case& a_case : all_cases()) {
    for (const double omega : speeds) {
      SCOPED_TRACE(a_case.id + " at " + std::to_string(omega));
      Scene scene = at_speed(scene_of(a_case, exploratory_scene()), omega);
      EXPECT_EQ(allocations_of([&] { surrogate_slope(scene, 0.25); }), 0);
      run_up(scene);
      const std::int64_t copy = allocations_of([&] { lifted<double>(scene); });
      EXPECT_GT(copy, 0);
      EXPECT_EQ(allocations_of([&] { surrogate_slope(scene, 0.25); }), copy);
    }
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
