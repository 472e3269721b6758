#pragma once

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/motion/impact_model.h"
#include "problems/carrier_track/motion/simulate.h"
#include "ricochet/machine.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {

/// All that a simulation tells, in the scalar it was run in.
template <class Scalar>
struct Watched : Observer {
  struct Hit {
    Scalar time;
    Wall wall;
    Scalar speed;
  };
  struct Top {
    Scalar time, position;
  };
  struct Stretch {
    Scalar time;
    Flight<Scalar> flight;
    Scalar duration;
  };

  void impact(const Scalar& time, Wall wall, const Scalar& speed) {
    hits.push_back({time, wall, speed});
  }
  void across_impact(const Scalar& time, Wall wall, const Scalar& speed) {
    across.push_back({time, wall, speed});
  }
  void peak(const Scalar& time, const Scalar& position) { tops.push_back({time, position}); }
  /// Those of a speed profile are not kept.
  template <class Path>
  void stretch(const Scalar& time, const Path& path, const Scalar& duration) {
    if constexpr (std::is_same_v<Path, Flight<Scalar>>) stretches.push_back({time, path, duration});
  }

  std::vector<Hit> hits;
  std::vector<Hit> across;  ///< in y
  std::vector<Top> tops;
  std::vector<Stretch> stretches;
  End<Scalar> end{};
};

/// Dual numbers run in a model of their own, because simulate() does not report their stretches.
template <class Scalar>
Watched<Scalar> watch(const BasicScene<Scalar>& scene) {
  Watched<Scalar> watched;
  if constexpr (Dual<Scalar>) {
    watched.end = scene.profile.empty()
                      ? ImpactModel<Scalar, AppliedForces<Scalar>>(scene).run(watched)
                      : ImpactModel<Scalar, ProfileForces<Scalar>>(scene).run(watched);
  } else {
    watched.end = simulate(scene, watched);
  }
  return watched;
}

/// Expects the value to be the other one but for this share of it.
inline void expect_close(double actual, double expected, double relative = 1e-12) {
  EXPECT_NEAR(actual, expected, relative * std::abs(expected));
}

/// Expects the same impacts, of any type with time, wall and speed, but for these tolerances;
/// `mirrored`: at the other wall each.
template <class Hits, class OtherHits>
void expect_hits(const Hits& actual, const OtherHits& expected, double time_tolerance,
                 double speed_tolerance, bool mirrored = false) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t k = 0; k < actual.size(); ++k) {
    ASSERT_EQ(actual[k].wall != expected[k].wall, mirrored) << "impact " << k;
    ASSERT_NEAR(actual[k].time, expected[k].time, time_tolerance) << "impact " << k;
    ASSERT_NEAR(actual[k].speed, expected[k].speed, speed_tolerance) << "impact " << k;
  }
}

/// Calls `look` with the draws of a seed time and again, until an assertion fails.
template <class Look>
void for_random(std::uint64_t seed, int trials, const Look& look) {
  RandomScenes draws(seed);
  for (int i = 0; i < trials && !testing::Test::HasFatalFailure(); ++i) {
    SCOPED_TRACE(i);
    look(draws);
  }
}

inline constexpr ContactLaw all_laws[] = {
    ContactLaw::hertz,          ContactLaw::kelvin_voigt,
    ContactLaw::hunt_crossley,  ContactLaw::lankarani_nikravesh,
    ContactLaw::zhiying_qishao, ContactLaw::flores,
    ContactLaw::gonthier,       ContactLaw::exact_restitution};

/// A random scene with a random law, stiffness and exponent.
inline Scene compliant_scene(RandomScenes& draws) {
  Scene scene = with(draws.next(), set::fidelity(Fidelity::compliant));
  scene.contact_law = all_laws[static_cast<std::size_t>(draws.within(0, 7.999))];
  scene.contact_exponent = draws.chance(0.5) ? 1.5 : draws.within(1.0, 2.5);
  if (scene.contact_law == ContactLaw::kelvin_voigt) scene.contact_exponent = 1;
  scene.stiffness = draws.log_within(1e4, 1e9);
  if (draws.chance(0.2)) scene.contact_speed = draws.log_within(0.01, 1.0);
  scene.restitution_lower = std::max(scene.restitution_lower, 0.05);
  scene.restitution_upper = std::max(scene.restitution_upper, 0.05);
  return scene;
}

/// Without those so slow that a body which glides back onto its wall strikes it, or not, by
/// rounding.
template <class Hits>
Hits distinct(Hits hits) {
  std::erase_if(hits, [](const auto& hit) { return !(hit.speed > 1e-6); });
  return hits;
}

}  // namespace ricochet::carrier_track
