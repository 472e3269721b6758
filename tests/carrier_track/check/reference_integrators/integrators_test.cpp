#include "problems/carrier_track/check/integrator.h"
#include "problems/carrier_track/check/method.h"
#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/motion/impact_model.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/check/reference_integrators/scenes.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

using std::numbers::pi;
using testing::HasSubstr;

TEST(Integrators, AreListedOnceTheReferenceFirst) {
  std::vector<std::string> names;
  for (const Integrator& integrator : all_integrators()) {
    names.push_back(integrator.name);
    EXPECT_THAT(integrator.version, testing::ContainsRegex("[0-9]"));
  }
  EXPECT_THAT(names, testing::ElementsAre("event-driven", "odeint-dopri5", "odeint-rosenbrock4",
                                          "cvode-adams", "cvode-bdf", "semi-implicit-euler",
                                          "runge-kutta-4", "moreau-jean", "penalty"));
  EXPECT_EQ(integrators_by(by_tolerance).size(), 4U);
  EXPECT_EQ(integrators_by(by_step).size(), 3U);
}

TEST(Integrators, WithLocatedEventsGiveTheBouncingBallItsClosedFormTimes) {
  for (const Integrator& integrator : integrators_by(by_tolerance)) {
    SCOPED_TRACE(integrator.name);
    const Outcome outcome = run(integrator, bouncing_ball(), 1e-10);
    ASSERT_GE(outcome.impacts.size(), 20U);
    for (std::size_t k = 0; k < 20; ++k) {
      EXPECT_NEAR(outcome.impacts[k].time, bounce_time(k), 1e-8 * bounce_time(k)) << k;
      EXPECT_EQ(outcome.impacts[k].wall, Wall::lower);
    }
    EXPECT_THAT(outcome.end, testing::FieldsAre(40.0, 0.0, 0.0));
  }
  // Of one step, they are exact on parabolas at any tolerance.
  for (const char* name : {"odeint-dopri5", "odeint-rosenbrock4"}) {
    const Outcome outcome = run(find_integrator(name), bouncing_ball(), 1e-2);
    for (std::size_t k = 0; k < 20; ++k) {
      EXPECT_NEAR(outcome.impacts.at(k).time, bounce_time(k), 1e-13 * bounce_time(k)) << name;
    }
  }
}

TEST(Integrators, StopASlidingBlockWhereFrictionHasUsedUpItsEnergy) {
  for (const double v0 : {0.1, -0.7}) {
    const double end = v0 * std::abs(v0) / (2 * block_friction);
    for_each_run(with(block(), set::start_velocity(v0), set::seconds(3)), 1e-4, 1e-10,
                 [&](const Outcome& outcome, const Integrator& integrator) {
                   EXPECT_NEAR(outcome.end.position, end,
                               steps_evenly(integrator) ? 1e-4 * std::abs(v0) : 1e-8);
                   EXPECT_EQ(outcome.end.velocity, 0.0);
                   EXPECT_TRUE(outcome.impacts.empty());
                 });
  }
}

TEST(Integrators, HoldABlockAgainstAnyForceWithinItsFriction) {
  for (const double pull : {-0.4998, 0.0, 0.4998}) {
    for_each_run(with(block(), set::pull(pull)), 1e-3, 1e-3, [](const Outcome& outcome, auto&) {
      EXPECT_THAT(outcome.end, testing::FieldsAre(1.0, 0.0, 0.0));
    });
  }
}

TEST(Integrators, LetABlockGoWhenTheForceExceedsItsFriction) {
  // The force 2 friction sin(omega t) exceeds friction from the angle pi/6 on. Twice integrated: 2
  // f sin(omega t) - f from the departure on, f friction.
  const double w = 3.0;
  const double f = block_friction;
  const double departure = pi / 6 / w;
  const double later = departure + 0.1;
  const double end = 2 * f / (w * w) * (std::sin(w * departure) - std::sin(w * later)) +
                     2 * f / w * std::cos(w * departure) * 0.1 - f * 0.1 * 0.1 / 2;
  const Scene scene = with(block(), set::omega(w), set::phase(-pi / 2), set::seconds(later),
                           set::centrifugal_mass_radius(2 * f * 0.8 / 9.0));
  for_each_run(scene, 1e-5, 1e-12, [&](const Outcome& outcome, const Integrator& integrator) {
    EXPECT_NEAR(outcome.end.position, end, steps_evenly(integrator) ? 1e-3 * end : 1e-10);
  });
}

TEST(Integrators, WithLocatedEventsAgreeWithTheEventDrivenOneOnRandomScenes) {
  for_random(7, 300, [](RandomScenes& draws) {
    const Scene scene = draws.next();
    const Outcome true_values = reference(scene);
    for (const Integrator& integrator : integrators_by(by_tolerance)) {
      const Outcome outcome = run(integrator, scene, 1e-10);
      EXPECT_TRUE(time_error(scene, outcome, true_values)) << integrator.name;
      EXPECT_NEAR(outcome.end.position, true_values.end.position, 1e-7) << integrator.name;
    }
  });
}

TEST(Integrators, OfFixedStepAgreeOnAllButAFewRandomScenes) {
  RandomScenes scenes(8);
  constexpr int count = 60;
  std::map<std::string, int> equal;
  for (int i = 0; i < count; ++i) {
    const Scene scene = scenes.next();
    const int expected = collisions(scene, reference(scene));
    for (const Integrator& integrator : integrators_by(by_step)) {
      equal[integrator.name] += collisions(scene, run(integrator, scene, 1e-5)) == expected;
    }
  }
  for (const auto& [name, scenes_alike] : equal) EXPECT_GE(scenes_alike, count * 9 / 10) << name;
}

TEST(SpeedProfile, IsFollowedAsByShortStepsAndByAdamsMoulton) {
  // All terms of equation (31), knots with and without a change of slope, sticking and Zeno ends.
  int compared = 0;
  int timed = 0;
  int impacts = 0;
  for_random(71, 150, [&](RandomScenes& draws) {
    Scene scene = draws.next();
    double time = draws.within(0, 0.2);
    for (int k = 0; k < 5; ++k) {
      scene.profile.push_back({time, scene.omega * draws.within(0.2, 2)});
      time += draws.within(0.05, 0.3);
    }
    scene.window = Seconds{draws.within(0.3, 1.5)};
    const Certainty certainty = record(scene, default_smoothing, 0).certainty;
    if (certainty.growth > 100 || certainty.margin.value_or(1) < 0.02) return;
    const Outcome exact = reference(scene);
    const Outcome stepped = run(find_integrator("semi-implicit-euler"), scene, 1e-5);
    EXPECT_EQ(collisions(scene, stepped), collisions(scene, exact));
    EXPECT_NEAR(stepped.end.position, exact.end.position, 2e-4);
    ++compared;
    // The peers look for a departure at samples, and may miss a short one at a knot.
    const auto error = time_error(scene, run(find_integrator("cvode-adams"), scene, 1e-12), exact);
    if (!error) return;
    EXPECT_LT(*error, 1e-7);
    impacts += collisions(scene, exact);
    ++timed;
  });
  EXPECT_GT(compared, 60);
  EXPECT_GE(timed, compared * 95 / 100);
  EXPECT_GT(impacts, 250);
}

/// Slope of the least-squares line through (ln control, ln error) at control = first / 2^k.
double order(double first, int count, const std::function<double(double)>& error) {
  double x_sum = 0;
  double y_sum = 0;
  double xx = 0;
  double xy = 0;
  for (int k = 0; k < count; ++k) {
    const double control = first * std::pow(0.5, k);
    const double x = std::log(control);
    const double y = std::log(error(control));
    x_sum += x;
    y_sum += y;
    xx += x * x;
    xy += x * y;
  }
  return (count * xy - x_sum * y_sum) / (count * xx - x_sum * x_sum);
}

TEST(Order, OfFixedStepsBetweenWallsIsThatOfTheMethod) {
  // No wall near and no friction: a flight under one harmonic, exact in the event-driven model.
  const Scene scene = with(Scene{}, set::walls(-100, 100), set::start(0, 0.3), set::disturbance(2),
                           set::disturbance_frequency(5));
  const double true_position = reference(scene).end.position;
  for (const auto& [name, expected] :
       {std::pair("semi-implicit-euler", 1), {"moreau-jean", 2}, {"runge-kutta-4", 4}}) {
    const Integrator integrator = find_integrator(name);
    const double found = order(0.05, 4, [&](double step) {
      return std::abs(run(integrator, scene, step).end.position - true_position);
    });
    EXPECT_NEAR(found, expected, 0.1) << name;
  }
}

TEST(Order, OfFixedStepsThroughImpactsIsOneAtMost) {
  // The naive reflection leaves nothing of the fourth order of Runge-Kutta; Moreau-Jean has the
  // order that theory gives it.
  for (const Integrator& integrator : integrators_by(by_step)) {
    const double found = order(0.01, 7, [&](double step) {
      const Outcome outcome = run(integrator, bouncing_ball(), step);
      double sum = 0;
      for (std::size_t k = 0; k < 12; ++k) {
        sum += std::abs(outcome.impacts.at(k).time - bounce_time(k));
      }
      return sum;
    });
    EXPECT_NEAR(found, 1, 0.25) << integrator.name;
  }
}

TEST(Order, ErrorsOfLocatedImpactTimesShrinkWithTheTolerance) {
  const Scene scene = shaken_gap();
  const Outcome true_values = reference(scene);
  ASSERT_GT(true_values.impacts.size(), 35U);
  for (const Integrator& integrator : integrators_by(by_tolerance)) {
    double last = infinity;
    for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
      const auto error = time_error(scene, run(integrator, scene, tolerance), true_values);
      EXPECT_LT(error.value_or(infinity), 0.2 * last) << integrator.name << " " << tolerance;
      last = error.value_or(0);
    }
    EXPECT_LT(last, 1e-9) << integrator.name;
  }
}

TEST(Order, OfRosenbrock4IsFourUnderForcesThatVary) {
  // Order four: a tolerance 1e4 times tighter takes 10 times the steps. With the coefficient d4
  // that Boost 1.74 has it is 100 times.
  const auto evaluations = [&](double tolerance) {
    const Outcome outcome = run(find_integrator("odeint-rosenbrock4"), shaken_gap(), tolerance);
    return static_cast<double>(outcome.force_evaluations);
  };
  const double ratio = evaluations(1e-10) / evaluations(1e-6);
  EXPECT_GT(ratio, 5);
  EXPECT_LT(ratio, 15);
}

// What the methods make of a carrier that just touches a wall, and of rests that hardly end or
// begin: documentation of where they fail as much as a test.

/// Whether a body strikes the upper wall, which its arc under pull and a harmonic overshoots by
/// `depth` [m], if negative misses. Without friction; the summit comes from the closed-form flight.
bool touches(const Integrator& integrator, double depth, double control) {
  Scene scene = with(Scene{}, set::pull(1), set::omega(100), set::centrifugal_mass_radius(1e-4),
                     set::restitution(0.5), set::start(0.5e-3, 0.02), set::seconds(0.03),
                     set::wall_upper(infinity));
  scene.wall_upper = record(scene, 0.1, 0).peaks.at(0).position - depth;
  const Outcome outcome = run(integrator, scene, control);
  return !outcome.impacts.empty() && outcome.impacts[0].wall == Wall::upper;
}

/// Whether it tells a wall overshot by `depth` from one missed by that.
bool discerns(const Integrator& integrator, double depth, double control) {
  return touches(integrator, depth, control) && !touches(integrator, -depth, control);
}

TEST(Grazing, EventDrivenFindsATouchDownToRoundingAndNothingShortOfIt) {
  for (const double depth : {1e-6, 1e-9, 1e-12, 1e-15}) {
    EXPECT_TRUE(discerns(find_integrator("event-driven"), depth, 0)) << depth;
  }
}

TEST(Grazing, SignChangesFindATouchOnlyIfItIsDeeperThanTheTolerance) {
  // Relative to the gap of 0.9 mm, the depth is 1e-3 and 1e-7.
  for (const Integrator& integrator : integrators_by(by_tolerance)) {
    EXPECT_TRUE(discerns(integrator, 1e-6, 1e-11)) << integrator.name;
    EXPECT_TRUE(discerns(integrator, 1e-10, 1e-11)) << integrator.name;
    EXPECT_FALSE(discerns(integrator, 1e-10, 1e-4)) << integrator.name;
  }
}

TEST(Grazing, SampledDeparturesMissAForceThatExceedsFrictionForAMoment) {
  // The force is friction / 0.99999 cos(omega t - 0.05) and exceeds friction while the angle is
  // within 0.0045 of 0.05, between the samples at 0 and 2 pi / 64.
  const Scene scene = with(block(), set::omega(3), set::phase(-0.05), set::seconds(0.5),
                           set::centrifugal_mass_radius(block_friction * 0.8 / 0.99999 / 9.0));
  EXPECT_GT(reference(scene).end.position, 0.0);
  for (const Integrator& integrator : integrators_by(by_tolerance)) {
    EXPECT_EQ(run(integrator, scene, 1e-10).end.position, 0.0) << integrator.name;
  }
}

TEST(Zeno, EndsInRest) {
  for_each_run(
      bouncing_ball(), 1e-3, 1e-8, [](const Outcome& outcome, const Integrator& integrator) {
        EXPECT_LT(outcome.impacts.size(), 200U);
        EXPECT_LT(outcome.impacts.back().time, 29.0);
        EXPECT_EQ(outcome.end.velocity, 0.0);
        // Moreau-Jean leaves a body a little inside the floor.
        EXPECT_NEAR(outcome.end.position, 0.0, integrator.name == "moreau-jean" ? 1e-5 : 0.0);
      });
}

// Every method has to end, with the end of the window or with a reason.

void expect_ends(const Scene& scene, double tolerance, double step) {
  for (const Integrator& integrator : all_integrators()) {
    SCOPED_TRACE(integrator.name);
    const Outcome outcome = integrator.run(scene, steps_evenly(integrator)         ? step
                                                  : integrator.setting == by_depth ? 1e-3
                                                                                   : tolerance);
    EXPECT_EQ(outcome.finished, outcome.failure.empty());
    EXPECT_TRUE(std::isfinite(outcome.end.position));
    EXPECT_TRUE(std::isfinite(outcome.end.velocity));
    EXPECT_LE(outcome.impacts.size(), most_impacts);
    if (outcome.finished) expect_close(outcome.end.time, duration_of(scene));
  }
}

TEST(HostileScene, WithPlasticOrElasticWallsIsFinished) {
  for (const double restitution : {0.0, 1.0}) {
    for (const double friction : {0.0, 0.2}) {
      for (const Integrator& integrator : all_integrators()) {
        run(integrator,
            with(paper_scene("C2", 7), set::restitution(restitution), set::friction(friction)),
            integrator.setting == by_depth ? 1e-3 : 1e-5);
      }
    }
  }
}

TEST(HostileScene, WithoutForcesIsFinished) {
  for (const double velocity : {0.0, -3.0}) {
    for_each_run(with(Scene{}, set::start_velocity(velocity)), 1e-6, 1e-6,
                 [&](const Outcome& outcome, auto&) {
                   EXPECT_EQ(outcome.impacts.size(), velocity == 0.0 ? 0U : 3U);
                 });
  }
}

TEST(HostileScene, ThatStartsOnAWallStrikesOrRestsAtOnce) {
  const double step = 1e-5;
  const Scene scene = with(Scene{}, set::restitution_lower(0.5), set::pull(1), set::start(0, -0.2));
  for_each_run(scene, step, step, [&](const Outcome& struck, auto&) {
    ASSERT_FALSE(struck.impacts.empty());
    EXPECT_NEAR(struck.impacts[0].time, 0.0, step);
    EXPECT_NEAR(struck.impacts[0].speed, 0.2, 2 * step);
  });
  for_each_run(with(scene, set::start_velocity(0)), step, step, [](const Outcome& resting, auto&) {
    EXPECT_TRUE(resting.impacts.empty());
    EXPECT_EQ(resting.end.position, 0.0);
  });
}

TEST(HostileScene, WithAVeryFastDriverEnds) {
  Scene scene = paper_scene("C4", 1e6);
  expect_ends(scene, 1e-6, 1e-10);
  scene.window = Seconds{5e-4};  // 80 turns
  expect_ends(scene, 1e-6, 1e-7);
  // And at rest from the start.
  expect_ends(with(scene, set::pull(0), set::centrifugal_mass_radius(0), set::disturbance(1e-3),
                   set::disturbance_frequency(1e9), set::start_velocity(0)),
              1e-6, 1e-6);
}

TEST(HostileScene, WithMoreThanAMillionImpactsIsGivenUp) {
  const Scene scene = with(Scene{}, set::wall_upper(1e-6), set::start(0.5e-6, 1), set::seconds(10));
  for (const char* name : {"event-driven", "runge-kutta-4", "moreau-jean"}) {
    const Outcome outcome = find_integrator(name).run(scene, 1e-6);
    EXPECT_FALSE(outcome.finished) << name;
    EXPECT_EQ(outcome.failure, "more than 1000000 impacts") << name;
    EXPECT_EQ(outcome.impacts.size(), most_impacts) << name;
  }
}

TEST(HostileScene, WithMoreThanAMillionStepsIsGivenUp) {
  // No wall is ever reached.
  const Scene scene =
      with(Scene{}, set::disturbance(1e6), set::disturbance_frequency(1e5), set::seconds(100));
  for (const char* name : {"odeint-dopri5", "cvode-adams"}) {
    const Outcome outcome = find_integrator(name).run(scene, 1e-6);
    EXPECT_FALSE(outcome.finished) << name;
    EXPECT_THAT(outcome.failure, HasSubstr("more than 1000000 steps")) << name;
  }
}

TEST(HostileScene, WithAnImpossibleControlEnds) {
  expect_ends(paper_scene("C4", 5.0), 1e-30, 1e-12);
  for (const Integrator& integrator : integrators_by(by_step)) {
    const Outcome outcome = integrator.run(paper_scene("C4", 5.0), 1e-12);
    EXPECT_FALSE(outcome.finished);
    EXPECT_THAT(outcome.failure, HasSubstr("more than 100000000 steps"));
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
