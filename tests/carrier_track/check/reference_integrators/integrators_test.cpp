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

TEST(Integrators, AreListedOnceTheReferenceFirst) {
  std::vector<std::tuple<std::string, std::string, bool>> listed;
  for (const Integrator& integrator : all_integrators()) {
    listed.emplace_back(integrator.name, integrator.setting, integrator.takes_compliant);
    EXPECT_THAT(integrator.version, testing::ContainsRegex("[0-9]"));
  }
  EXPECT_THAT(listed, ElementsAre(FieldsAre("event-driven", no_setting, true),
                                  FieldsAre("odeint-dopri5", by_tolerance, true),
                                  FieldsAre("odeint-rosenbrock4", by_tolerance, true),
                                  FieldsAre("cvode-adams", by_tolerance, true),
                                  FieldsAre("cvode-bdf", by_tolerance, true),
                                  FieldsAre("semi-implicit-euler", by_step, true),
                                  FieldsAre("runge-kutta-4", by_step, true),
                                  FieldsAre("moreau-jean", by_step, false),
                                  FieldsAre("penalty", by_depth, false)));
}

TEST(Integrators, WithLocatedEventsGiveTheBouncingBallItsClosedFormTimes) {
  for (const Integrator& integrator : integrators_by(by_tolerance)) {
    SCOPED_TRACE(integrator.name);
    const Outcome outcome = run(integrator, bouncing_ball(), 1e-10);
    for (std::size_t k = 0; k < bounces.size(); ++k) {
      expect_close(outcome.impacts.at(k).time, bounces[k].time, 1e-8);
      EXPECT_EQ(outcome.impacts[k].wall, Wall::lower);
    }
    EXPECT_THAT(outcome.end, FieldsAre(40.0, 0.0, 0.0));
  }
  // Of one step, they are exact on parabolas at any tolerance.
  for (const char* name : {"odeint-dopri5", "odeint-rosenbrock4"}) {
    const Outcome outcome = run(name, bouncing_ball(), 1e-2);
    for (std::size_t k = 0; k < bounces.size(); ++k) {
      expect_close(outcome.impacts.at(k).time, bounces[k].time, 1e-13);
    }
  }
}

TEST(Integrators, LeaveABlockWhereFrictionStopsHoldsAndReleasesIt) {
  const double f = block_friction;
  // The last force, 2 friction sin(3 t), exceeds friction from the angle pi/6 on.
  const double later = pi / 18 + 0.1;
  const Scene released = with(block(), set::omega(3), set::phase(-pi / 2), set::seconds(later),
                              set::centrifugal_mass_radius(2 * f * 0.8 / 9.0));
  const double released_end = 2 * f / 9 * (std::sin(pi / 6) - std::sin(3 * later)) +
                              2 * f / 3 * std::cos(pi / 6) * 0.1 - f * 0.1 * 0.1 / 2;
  for (const auto& [scene, end] :
       {std::pair(with(block(), set::start_velocity(0.1), set::seconds(3)), 0.01 / (2 * f)),
        {with(block(), set::start_velocity(-0.7), set::seconds(3)), -0.49 / (2 * f)},
        {with(block(), set::pull(-0.4998)), 0.0},
        {block(), 0.0},
        {with(block(), set::pull(0.4998)), 0.0},
        {released, released_end}}) {
    for_each_run(
        scene, 1e-5, 1e-12,
        [&, &end = end, &scene = scene](const Outcome& outcome, const Integrator& integrator) {
          const double error = steps_evenly(integrator) ? 1e-3 * std::abs(end) : 1e-10;
          EXPECT_NEAR(outcome.end.position, end, end == 0 ? 0 : error);
          EXPECT_EQ(outcome.end.velocity == 0, end != released_end);
          EXPECT_TRUE(outcome.impacts.empty());
          expect_close(outcome.end.time, duration_of(scene));
        });
  }
}

TEST(Integrators, WithLocatedEventsAgreeWithTheEventDrivenOneOnRandomScenes) {
  for_random(7, 300, [](RandomScenes& draws) {
    const Scene scene = draws.next();
    const Outcome true_values = reference(scene);
    for (const Integrator& integrator : integrators_by(by_tolerance)) {
      const Outcome outcome = run(integrator, scene, 1e-10);
      EXPECT_LT(time_error(scene, outcome, true_values), infinity) << integrator.name;
      EXPECT_NEAR(outcome.end.position, true_values.end.position, 1e-7) << integrator.name;
    }
  });
}

TEST(Integrators, OfFixedStepAgreeOnAllButAFewRandomScenes) {
  constexpr int trials = 60;
  std::map<std::string, int> equal;
  for_random(8, trials, [&](RandomScenes& draws) {
    const Scene scene = draws.next();
    const int expected = collisions(scene, reference(scene));
    for (const Integrator& integrator : integrators_by(by_step)) {
      equal[integrator.name] += collisions(scene, run(integrator, scene, 1e-5)) == expected;
    }
  });
  EXPECT_EQ(equal.size(), 3U);
  for (const auto& [name, scenes] : equal) EXPECT_GE(scenes, trials * 9 / 10) << name;
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
    const Outcome stepped = run("semi-implicit-euler", scene, 1e-5);
    EXPECT_EQ(collisions(scene, stepped), collisions(scene, exact));
    EXPECT_NEAR(stepped.end.position, exact.end.position, 2e-4);
    ++compared;
    // The peers look for a departure at samples, and may miss a short one at a knot.
    const double error = time_error(scene, run("cvode-adams", scene, 1e-12), exact);
    if (error == infinity) return;
    EXPECT_LT(error, 1e-7);
    impacts += collisions(scene, exact);
    ++timed;
  });
  EXPECT_GT(compared, 60);
  EXPECT_GE(timed, compared * 95 / 100);
  EXPECT_GT(impacts, 250);
}

/// Slope of the least-squares line through (ln control, ln error) at control = first / 2^k.
double order(double first, int count, const std::function<double(double)>& error) {
  double sum = 0, squares = 0;
  for (int k = 0; k < count; ++k) {
    const double place = 0.5 * (count - 1) - k;
    sum += place * std::log2(error(first * std::pow(0.5, k)));
    squares += place * place;
  }
  return sum / squares;
}

TEST(Order, OfFixedStepsBetweenWallsIsThatOfTheMethod) {
  // No wall near and no friction: a flight under one harmonic, exact in the event-driven model.
  const Scene scene = with(Scene{}, set::walls(-100, 100), set::start(0, 0.3), set::disturbance(2),
                           set::disturbance_frequency(5));
  const double true_position = reference(scene).end.position;
  for (const auto& [name, expected] :
       {std::pair("semi-implicit-euler", 1), {"moreau-jean", 2}, {"runge-kutta-4", 4}}) {
    const auto error = [&, &name = name](double step) {
      return std::abs(run(name, scene, step).end.position - true_position);
    };
    EXPECT_NEAR(order(0.05, 4, error), expected, 0.1) << name;
  }
}

TEST(Order, OfFixedStepsThroughImpactsIsOneAtMost) {
  // The naive reflection leaves nothing of the fourth order of Runge-Kutta; Moreau-Jean has the
  // order that theory gives it.
  for (const Integrator& integrator : integrators_by(by_step)) {
    const auto error = [&](double step) {
      const Outcome outcome = run(integrator, bouncing_ball(), step);
      double sum = 0;
      for (std::size_t k = 0; k < 12; ++k) {
        sum += std::abs(outcome.impacts.at(k).time - bounces[k].time);
      }
      return sum;
    };
    EXPECT_NEAR(order(0.01, 7, error), 1, 0.25) << integrator.name;
  }
}

TEST(Order, ErrorsOfLocatedImpactTimesShrinkWithTheTolerance) {
  const Scene scene = shaken_gap();
  const Outcome true_values = reference(scene);
  ASSERT_GT(true_values.impacts.size(), 35U);
  for (const Integrator& integrator : integrators_by(by_tolerance)) {
    double last = infinity;
    for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
      const double error = time_error(scene, run(integrator, scene, tolerance), true_values);
      EXPECT_LT(error, 0.2 * last) << integrator.name << " " << tolerance;
      last = error;
    }
    EXPECT_LT(last, 1e-9) << integrator.name;
  }
}

TEST(Order, OfRosenbrock4IsFourUnderForcesThatVary) {
  // Order four: a tolerance 1e4 times tighter takes 10 times the steps. With the coefficient d4
  // that Boost 1.74 has it is 100 times.
  const auto evaluations = [](double tolerance) {
    return run("odeint-rosenbrock4", shaken_gap(), tolerance).force_evaluations;
  };
  EXPECT_GT(evaluations(1e-10), 5 * evaluations(1e-6));
  EXPECT_LT(evaluations(1e-10), 15 * evaluations(1e-6));
}

// What the methods make of a carrier that just touches a wall, and of rests that hardly end or
// begin: documentation of where they fail as much as a test.

/// Whether it finds that a body strikes the upper wall where its arc under pull and a harmonic
/// overshoots it by `depth` [m], and that it misses the wall where that is as far away. Without
/// friction; the summit comes from the closed-form flight.
bool discerns(const Integrator& integrator, double depth, double control) {
  Scene scene = with(Scene{}, set::pull(1), set::omega(100), set::centrifugal_mass_radius(1e-4),
                     set::restitution(0.5), set::start(0.5e-3, 0.02), set::seconds(0.03),
                     set::wall_upper(infinity));
  const double summit = record(scene, 0.1, 0).peaks.at(0).position;
  const auto touches = [&](double wall) {
    const Outcome outcome = run(integrator, with(scene, set::wall_upper(wall)), control);
    return !outcome.impacts.empty() && outcome.impacts[0].wall == Wall::upper;
  };
  return touches(summit - depth) && !touches(summit + depth);
}

TEST(Grazing, IsFoundDownToRoundingByTheEventDrivenAndDownToTheToleranceByTheOthers) {
  for (const double depth : {1e-6, 1e-9, 1e-12, 1e-15}) {
    EXPECT_TRUE(discerns(find_integrator("event-driven"), depth, 0)) << depth;
  }
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
    const double control = steps_evenly(integrator)         ? step
                           : integrator.setting == by_depth ? 1e-3
                                                            : tolerance;
    const Outcome outcome = integrator.run(scene, control);
    EXPECT_EQ(outcome.finished, outcome.failure.empty());
    EXPECT_TRUE(std::isfinite(outcome.end.position));
    EXPECT_TRUE(std::isfinite(outcome.end.velocity));
    EXPECT_LE(outcome.impacts.size(), most_impacts);
    if (outcome.finished) expect_close(outcome.end.time, duration_of(scene));
  }
}

void expect_given_up(const std::string& name, const Scene& scene, double control,
                     const std::string& why) {
  const Outcome outcome = find_integrator(name).run(scene, control);
  EXPECT_FALSE(outcome.finished) << name;
  EXPECT_THAT(outcome.failure, HasSubstr(why)) << name;
  EXPECT_EQ(outcome.impacts.size() == most_impacts, why.ends_with("impacts")) << name;
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
    expect_given_up(name, scene, 1e-6, "more than 1000000 impacts");
  }
}

TEST(HostileScene, WithMoreThanAMillionStepsIsGivenUp) {
  // No wall is ever reached.
  const Scene scene =
      with(Scene{}, set::disturbance(1e6), set::disturbance_frequency(1e5), set::seconds(100));
  for (const char* name : {"odeint-dopri5", "cvode-adams"}) {
    expect_given_up(name, scene, 1e-6, "more than 1000000 steps");
  }
}

TEST(HostileScene, WithAnImpossibleControlEnds) {
  expect_ends(paper_scene("C4", 5.0), 1e-30, 1e-12);
  for (const Integrator& integrator : integrators_by(by_step)) {
    expect_given_up(integrator.name, paper_scene("C4", 5.0), 1e-12, "more than 100000000 steps");
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
