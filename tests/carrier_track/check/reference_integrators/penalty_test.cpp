#include "problems/carrier_track/check/integrator.h"
#include "problems/carrier_track/check/method.h"
#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/check/reference_integrators/scenes.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

/// Those that take compliant walls.
std::vector<Integrator> through_walls() {
  std::vector<Integrator> chosen = all_integrators();
  std::erase_if(chosen, [](const Integrator& i) { return !i.takes_compliant; });
  return chosen;
}

double control_of(const Integrator& integrator, double step, double tolerance) {
  return steps_evenly(integrator) ? step : tolerance;
}

/// The same scene between compliant walls.
Scene soft(const Scene& scene, ContactLaw law, double stiffness) {
  return with(scene, set::fidelity(Fidelity::compliant), set::contact_law(law),
              set::contact_exponent(law == ContactLaw::kelvin_voigt ? 1 : 1.5),
              set::stiffness(stiffness));
}

/// 1 kg at 1 m/s towards a wall at 0 of 1 N/m^n, 0.3 m away; nothing else acts.
Scene one_impact(ContactLaw law, double restitution) {
  return soft(with(Scene{}, set::wall_upper(100), set::start(0.3, -1),
                   set::restitution_lower(restitution), set::seconds(9)),
              law, 1);
}

Scene compliant_gap(double stiffness = 1e10) {
  return soft(with(shaken_gap(), set::contact_speed(0.03), set::seconds(0.5)),
              ContactLaw::exact_restitution, stiffness);
}

/// A body of 1 kg that starts on the surface of a damped wall, pressed with 10 N.
Scene resting_body(ContactLaw law, double stiffness) {
  return soft(with(Scene{}, set::wall_upper(1e-3), set::start_position(0), set::pull(10),
                   set::restitution_lower(0.5), set::contact_speed(0.03), set::seconds(0.3)),
              law, stiffness);
}

TEST(Penalty, MethodsRefuseFrictionAndTheOthersCompliantWalls) {
  const Scene rough = with(compliant_gap(), set::friction(0.1), set::normal_force(1));
  for (const Integrator& integrator : all_integrators()) {
    if (integrator.setting == no_setting) continue;
    const Outcome outcome = integrator.run(rough, 1e-3);
    EXPECT_FALSE(outcome.finished);
    EXPECT_EQ(outcome.failure, integrator.takes_compliant
                                   ? "through compliant walls there is no friction here"
                                   : "the walls must be hard");
    EXPECT_EQ(integrator.run(compliant_gap(), 1e-5).finished, integrator.takes_compliant);
  }
}

TEST(Penalty, SpringsForHardWallsConvergeToThem) {
  for (const double friction : {0.0, 0.5}) {
    const Scene scene =
        with(shaken_gap(), set::seconds(0.5), set::friction(friction), set::normal_force(0.1));
    for (const double e : {0.0, 1.0}) run("penalty", with(scene, set::restitution(e)), 1e-3);
    const Outcome true_values = reference(scene);
    ASSERT_GE(true_values.impacts.size(), 8U);
    double last = infinity;
    for (const double depth : {1e-2, 1e-3, 1e-4}) {
      const Outcome outcome = run("penalty", scene, depth);
      const double error = time_error(scene, outcome, true_values);
      EXPECT_LT(error, 0.5 * last) << depth;
      last = error;
      EXPECT_GT(outcome.deepest, 0);
      EXPECT_LT(outcome.deepest, depth * scene.wall_upper);
    }
  }
}

TEST(Penalty, MethodsReturnTheRestitutionOfEveryLawAndSeeHowDeepTheBodyGoes) {
  struct Impacting {
    ContactLaw law;
    std::optional<double> contact_speed;
    double restitution;
  };
  const auto damping = [](ContactLaw law) { return dissipation(law, 0.5); };
  for (const auto& [law, contact_speed, restitution] :
       {Impacting{ContactLaw::hertz, {}, 1},
        {ContactLaw::kelvin_voigt, {}, 0.5},
        {ContactLaw::hunt_crossley, {}, returned_restitution(damping(ContactLaw::hunt_crossley))},
        {ContactLaw::exact_restitution, {}, 0.5},
        // At a tenth of contact_speed a wall returns what a tenth of the damping does.
        {ContactLaw::exact_restitution, 10.0,
         returned_restitution(damping(ContactLaw::exact_restitution) / 10)}}) {
    const Scene scene = with(one_impact(law, 0.5), set::contact_speed(contact_speed));
    for (const Integrator& integrator : through_walls()) {
      SCOPED_TRACE(testing::Message() << integrator.name << " " << static_cast<int>(law));
      const Outcome outcome = run(integrator, scene, control_of(integrator, 1e-4, 1e-9));
      // Of an adaptive method: a hundred steps, each with the tolerance times the gap's 100 m.
      EXPECT_NEAR(outcome.end.velocity, restitution, control_of(integrator, 1e-4, 1e-5));
      ASSERT_EQ(outcome.impacts.size(), 1U);
      EXPECT_NEAR(outcome.impacts[0].time, 0.3, 1e-12);
      EXPECT_NEAR(outcome.impacts[0].speed, 1, 1e-12);
      EXPECT_EQ(outcome.impacts[0].wall, Wall::lower);
      if (law == ContactLaw::hertz && steps_evenly(integrator)) {
        EXPECT_NEAR(outcome.deepest, std::pow(1.25, 0.4), 1e-4);  // in closed form
      }
    }
  }
}

TEST(Penalty, MethodsConvergeToTheCompliantModelInAShakenGap) {
  const Scene scene = compliant_gap();
  const Outcome true_values = reference(scene);
  ASSERT_GE(true_values.impacts.size(), 8U);
  for (const Integrator& integrator : through_walls()) {
    if (integrator.setting == no_setting) continue;
    const auto error = [&](double step, double tolerance) {
      const double control = control_of(integrator, step, tolerance);
      return time_error(scene, run(integrator, scene, control), true_values);
    };
    const double loose = error(1e-5, 1e-7), tight = error(1e-6, 1e-11);
    EXPECT_LT(loose, infinity) << integrator.name;
    EXPECT_LT(tight, 0.2 * loose) << integrator.name;
    EXPECT_LT(tight, control_of(integrator, 1e-5, 1e-9)) << integrator.name;
  }
}

TEST(Penalty, MethodsEndWithAReasonWhateverTheControl) {
  for (const Integrator& integrator : through_walls()) {
    for (const double control : {1e-30, 1e-3, 1.0}) {
      SCOPED_TRACE(testing::Message() << integrator.name << " " << control);
      const Outcome outcome = integrator.run(compliant_gap(1e16), control);
      EXPECT_EQ(outcome.finished, outcome.failure.empty());
      EXPECT_TRUE(std::isfinite(outcome.end.position) && std::isfinite(outcome.end.velocity));
      if (!steps_evenly(integrator) || control != 1e-3) continue;
      EXPECT_EQ(outcome.failure, "the body has left the walls by more than the gap");
      EXPECT_EQ(outcome.deepest, infinity);
    }
  }
}

/// A body of 1 kg on an elastic spring of 1 N/m, w = 1/s, that a force 1 - cos(0.01 t) N presses in
/// so slowly that it swings hardly at all: the depth is that force over 1 N/m, 2 m at most.
Scene pressed_slowly() {
  return with(one_impact(ContactLaw::hertz, 1), set::contact_exponent(1), set::start(0, 0),
              set::pull(1), set::disturbance(1), set::disturbance_frequency(0.01),
              set::seconds(350));
}

TEST(Penalty, FixedStepsStayOnASpringAsLongAsTheyAreStable) {
  // Semi-implicit Euler up to 2, Runge-Kutta up to the root of 8.
  for (const auto& [name, stable, unstable] :
       {std::tuple("semi-implicit-euler", 1.8, 2.2), {"runge-kutta-4", 2.7, 3.0}}) {
    for (const double step : {0.5, 1.0, stable}) {
      EXPECT_NEAR(run(name, pressed_slowly(), step).deepest, 2, 0.01) << name << " " << step;
    }
    EXPECT_GT(find_integrator(name).run(pressed_slowly(), unstable).deepest, 10) << name;
  }
}

TEST(Penalty, SemiImplicitEulerThrowsABodyOutOfALinearWallByTheClosedForm) {
  // A step that ends d = u h v deep, 0 < u <= 1, is followed by one that leaves with
  // v (w^2 h^2 u - 1) where that lifts it out: u (w^2 h^2 - 1) > 1. With h w = 1.8, u = 0.9: 1.916.
  const double h = 1.8, u = 0.9;
  const Scene scene = with(one_impact(ContactLaw::hertz, 1), set::contact_exponent(1),
                           set::start_position(2 * h - u * h), set::seconds(20 * h));
  const Outcome outcome = run("semi-implicit-euler", scene, h);
  EXPECT_NEAR(outcome.end.velocity, h * h * u - 1, 1e-12);
  EXPECT_NEAR(*outcome.gained, h * h * u - 2, 1e-12);
  EXPECT_NEAR(outcome.deepest, u * h, 1e-12);
}

TEST(Penalty, ExplicitErrorControlPaysForRestOnAStiffWall) {
  // Ten thousand times the stiffness is, with the frequency ~ K^(1/3) of a pressed Hertz contact,
  // 21.5 times the steps for a method that is bound by stability.
  const auto evaluations = [](const char* name, double stiffness) {
    return run(name, resting_body(ContactLaw::exact_restitution, stiffness), 1e-6)
        .force_evaluations;
  };
  const auto soft = evaluations("odeint-dopri5", 1e10), stiff = evaluations("odeint-dopri5", 1e14);
  EXPECT_GT(stiff, 10 * soft);
  EXPECT_LT(stiff, 40 * soft);
  EXPECT_LT(3 * evaluations("odeint-rosenbrock4", 1e16), evaluations("odeint-dopri5", 1e16));
}

TEST(Penalty, OnlyTheRosenbrockMethodSettlesToRoundingOnAStiffWall) {
  const auto error = [](const char* name) {
    const Scene scene = resting_body(ContactLaw::exact_restitution, 1e14);
    return std::abs(run(name, scene, 1e-6).end.position / std::pow(10 / 1e14, 2.0 / 3) + 1);
  };
  EXPECT_LT(error("event-driven"), 1e-9);
  EXPECT_LT(error("odeint-rosenbrock4"), 1e-9);
  EXPECT_GT(error("odeint-dopri5"), 1e-6);
}

TEST(Penalty, BdfRestsInAStiffViscousWallForMuchLessThanAdams) {
  // w = 3.2e6 1/s: explicit and fixed-point iterations must follow it for ever.
  const Scene scene = resting_body(ContactLaw::kelvin_voigt, 1e13);
  EXPECT_LT(20 * run("cvode-bdf", scene, 1e-6).force_evaluations,
            find_integrator("cvode-adams").run(scene, 1e-6).force_evaluations);
}

WallForce wall_of(ContactLaw law, double exponent) {
  return wall_force_of(with(soft(Scene{}, law, 300), set::mass(0.8), set::restitution_lower(0.5),
                            set::restitution_upper(0.7), set::contact_exponent(exponent),
                            set::contact_speed(2)));
}

TEST(WallForce, IsTheContactLawOverTheMass) {
  const WallForce wall = wall_of(ContactLaw::hunt_crossley, 1.5);
  // K d^n (1 + D d'/v0) / m, with D = 3 (1 - c) / 2: 0.75 below, 0.45 above.
  const double spring = 300 / 0.8 * std::pow(0.01, 1.5);
  EXPECT_NEAR(wall({-0.01, -1}), spring * (1 + 0.75 / 2), 1e-12);
  EXPECT_NEAR(wall({-0.01, +1}), spring * (1 - 0.75 / 2), 1e-12);
  EXPECT_NEAR(wall({1.01, +1}), -spring * (1 + 0.45 / 2), 1e-12);
  EXPECT_EQ(wall({0.5, 3}), 0);
  EXPECT_EQ(wall({0, -3}), 0);
}

TEST(WallForce, OfKelvinAndVoigtPullsOnlyWhereItMay) {
  WallForce wall = wall_of(ContactLaw::kelvin_voigt, 1);
  const double spring = 300 / 0.8 * 0.01;
  const double damping = 2 * damping_ratio(0.5, Release::zero_force) * std::sqrt(300 / 0.8);  // C/m
  EXPECT_NEAR(wall({-0.01, -1}), spring + damping, 1e-12);
  EXPECT_GT(damping, spring);
  EXPECT_EQ(wall({-0.01, +1}), 0);
  wall.pulls = true;
  EXPECT_NEAR(wall({-0.01, +1}), spring - damping, 1e-12);
  EXPECT_NEAR(wall.slopes({-0.01, +1}).by_velocity, -damping, 1e-12);
}

TEST(WallForce, HasTheSlopesOfItsDifferences) {
  RandomScenes draws(5);
  for (const double exponent : {1.0, 1.5, 2.2}) {
    for (const ContactLaw law : {ContactLaw::flores, ContactLaw::kelvin_voigt}) {
      const WallForce wall = wall_of(law, exponent);
      for (int i = 0; i < 40; ++i) {
        const double d = draws.within(0.01, 0.1), h = 1e-6;
        const double x = i % 2 ? -d : 1 + d, v = draws.within(-1, 1);
        const auto slopes = wall.slopes({x, v});
        const double by_position = (wall({x + h, v}) - wall({x - h, v})) / (2 * h);
        const double by_velocity = (wall({x, v + h}) - wall({x, v - h})) / (2 * h);
        EXPECT_NEAR(slopes.by_position, by_position, 1e-5 * (1 + std::abs(by_position)));
        EXPECT_NEAR(slopes.by_velocity, by_velocity, 1e-5 * (1 + std::abs(by_velocity)));
      }
    }
  }
}

TEST(Forces, AreThoseOfEquation31AndChangeAtTheRateThatTheyTell) {
  for_random(3, 200, [](RandomScenes& draws) {
    Scene scene = with(draws.next(), set::seconds(2));
    if (draws.chance(0.5)) scene.profile = {{0.1, scene.omega}, {1.1, draws.within(0.5, 20)}};
    const Forces forces(scene);
    const double h = 1e-6;
    for (const double t : {draws.within(0, 0.09), draws.within(0.2, 1), draws.within(1.2, 2)}) {
      const auto at = [&](double time) { return force_of_plate(scene, time) / scene.mass; };
      EXPECT_NEAR(forces.applied(t), at(t), 1e-12);
      const double slope = (at(t + h) - at(t - h)) / (2 * h);
      EXPECT_NEAR(forces.applied_rate(t, t), slope, 1e-6 * (1 + std::abs(slope)));
    }
  });
}

TEST(Forces, HaveThePeriodOfTheFastestThatActs) {
  Scene scene = with(Scene{}, set::omega(5), set::disturbance_frequency(8));
  const auto frequency = [&] { return 2 * std::numbers::pi / Forces(scene).shortest_period(); };
  EXPECT_EQ(frequency(), 0);
  scene.slider_mass_radius = 1;
  EXPECT_DOUBLE_EQ(frequency(), 5);
  scene.disturbance = 1;
  EXPECT_DOUBLE_EQ(frequency(), 8);
}

TEST(Forces, OfAProfileAreThoseOfEveryPieceContinuedBeyondItsEnds) {
  // omega = 2, then 2 + 2 (t - 0.5) until 1.5, then 4.
  const Forces forces(with(Scene{}, set::mass(2), set::slider_mass_radius(0.3), set::seconds(2),
                           set::profile(std::vector<SpeedKnot<double>>{{0.5, 2}, {1.5, 4}})));
  EXPECT_EQ(forces.smooth_until(0.2), 0.5);
  EXPECT_EQ(forces.smooth_until(0.5), 1.5);
  EXPECT_NEAR(forces.applied(1.25, 0), -0.15 * 4 * std::cos(2 * 1.25), 1e-14);
  EXPECT_NEAR(forces.strongest(), 0.15 * (16 + 2), 1e-12);
  EXPECT_DOUBLE_EQ(forces.shortest_period(), 2 * std::numbers::pi / 4);
}

}  // namespace
}  // namespace ricochet::carrier_track
