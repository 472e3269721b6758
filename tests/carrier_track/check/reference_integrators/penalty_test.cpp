#include <gmock/gmock.h>

#include <cmath>

#include "problems/carrier_track/check/integrator.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/check/reference_integrators/accuracy.h"
#include "tests/carrier_track/check/reference_integrators/scenes.h"

namespace ricochet::carrier_track {
namespace {

/// Those that take compliant walls.
std::vector<Integrator> through_walls() {
  std::vector<Integrator> chosen = all_integrators();
  std::erase_if(chosen, [](const Integrator& i) { return !i.takes_compliant; });
  return chosen;
}

bool fixed(const Integrator& integrator) {
  return integrator.setting == "step [s]";
}

/// 1 kg at 1 m/s towards a wall at 0 of 1 N/m^n, 0.3 m away; nothing else acts.
Scene one_impact(ContactLaw law, double exponent, double restitution) {
  Scene scene;
  scene.wall_upper = 100;
  scene.start_position = 0.3;
  scene.start_velocity = -1;
  scene.restitution_lower = restitution;
  scene.fidelity = Fidelity::compliant;
  scene.contact_law = law;
  scene.contact_exponent = exponent;
  scene.stiffness = 1;
  scene.window = Seconds{9};
  return scene;
}

Scene compliant_gap() {
  Scene scene = shaken_gap();
  scene.fidelity = Fidelity::compliant;
  scene.contact_law = ContactLaw::exact_restitution;
  scene.stiffness = 1e10;
  scene.contact_speed = 0.03;
  scene.window = Seconds{0.5};
  return scene;
}

/// A body of 1 kg that starts on the surface of a damped wall, pressed with 10 N.
Scene resting_body(ContactLaw law, double stiffness) {
  Scene scene;
  scene.wall_upper = 1e-3;
  scene.start_position = 0;
  scene.pull = 10;
  scene.restitution_lower = 0.5;
  scene.fidelity = Fidelity::compliant;
  scene.contact_law = law;
  scene.contact_exponent = law == ContactLaw::kelvin_voigt ? 1 : 1.5;
  scene.contact_speed = 0.03;
  scene.stiffness = stiffness;
  scene.window = Seconds{0.3};
  return scene;
}

TEST(Penalty, MethodsAreListedOnceTheReferenceFirst) {
  std::vector<std::string> names;
  for (const Integrator& integrator : through_walls()) names.push_back(integrator.name);
  EXPECT_THAT(names, testing::ElementsAre("event-driven", "odeint-dopri5", "odeint-rosenbrock4",
                                          "cvode-adams", "cvode-bdf", "semi-implicit-euler",
                                          "runge-kutta-4"));
}

TEST(Penalty, MethodsRefuseFrictionAndTheOthersCompliantWalls) {
  Scene rough = compliant_gap();
  rough.friction = 0.1;
  rough.normal_force = 1;
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
    Scene scene = shaken_gap();
    scene.window = Seconds{0.5};
    scene.friction = friction;
    scene.normal_force = 0.1;
    const Outcome true_values = reference(scene);
    ASSERT_GE(true_values.impacts.size(), 8U);
    double last = infinity;
    for (const double depth : {1e-2, 1e-3, 1e-4}) {
      const Outcome outcome = run(find_integrator("penalty"), scene, depth);
      const Accuracy accuracy = compare(scene, outcome, true_values);
      EXPECT_EQ(accuracy.missed + accuracy.spurious, 0) << depth;
      EXPECT_LT(accuracy.impact_time_error.value_or(infinity), 0.5 * last) << depth;
      last = accuracy.impact_time_error.value_or(infinity);
      EXPECT_GT(outcome.deepest, 0);
      EXPECT_LT(outcome.deepest, depth * scene.wall_upper);
    }
  }
}

TEST(Penalty, MethodsReturnTheRestitutionOfEveryLaw) {
  for (const ContactLaw law : {ContactLaw::hertz, ContactLaw::kelvin_voigt,
                               ContactLaw::hunt_crossley, ContactLaw::exact_restitution}) {
    const bool viscous = law == ContactLaw::kelvin_voigt;
    const double expected = viscous ? 0.5 : returned_restitution(dissipation(law, 0.5));
    for (const Integrator& integrator : through_walls()) {
      const Outcome outcome =
          run(integrator, one_impact(law, viscous ? 1 : 1.5, 0.5), fixed(integrator) ? 1e-4 : 1e-9);
      // Of an adaptive method: a hundred steps, each with the tolerance times the gap's 100 m.
      EXPECT_NEAR(outcome.end.velocity, expected, fixed(integrator) ? 1e-4 : 1e-5)
          << integrator.name << " " << static_cast<int>(law);
      ASSERT_EQ(outcome.impacts.size(), 1U) << integrator.name;
      EXPECT_NEAR(outcome.impacts[0].time, 0.3, 1e-12) << integrator.name;
      EXPECT_NEAR(outcome.impacts[0].speed, 1, 1e-12) << integrator.name;
      EXPECT_EQ(outcome.impacts[0].wall, Wall::lower);
    }
  }
}

TEST(Penalty, MethodsSeeHowDeepTheBodyGoes) {
  // 1.25^(2/5) m for Hertz.
  for (const Integrator& integrator : through_walls()) {
    if (!fixed(integrator)) continue;
    const Outcome outcome = run(integrator, one_impact(ContactLaw::hertz, 1.5, 1), 1e-4);
    EXPECT_NEAR(outcome.deepest, std::pow(1.25, 0.4), 1e-4) << integrator.name;
  }
}

TEST(Penalty, DampingIsScaledWithTheSpeedOfEveryImpactOrWithOne) {
  // At a tenth of contact_speed a wall returns what a tenth of the damping does.
  Scene scene = one_impact(ContactLaw::exact_restitution, 1.5, 0.5);
  for (const Integrator& integrator : through_walls()) {
    const double control = fixed(integrator) ? 1e-4 : 1e-9;
    scene.contact_speed.reset();
    EXPECT_NEAR(run(integrator, scene, control).end.velocity, 0.5, 1e-4) << integrator.name;
    scene.contact_speed = 10;
    const double weak = returned_restitution(dissipation(scene.contact_law, 0.5) / 10);
    EXPECT_NEAR(run(integrator, scene, control).end.velocity, weak, 1e-4) << integrator.name;
    EXPECT_GT(weak, 0.8);
  }
}

TEST(Penalty, MethodsConvergeToTheCompliantModelInAShakenGap) {
  const Scene scene = compliant_gap();
  const Outcome true_values = run(through_walls().front(), scene, 0);
  ASSERT_GE(true_values.impacts.size(), 8U);
  for (const Integrator& integrator : through_walls()) {
    if (integrator.setting == "none") continue;
    const double loose = fixed(integrator) ? 1e-5 : 1e-7;
    const auto error = [&](double control) {
      const Accuracy accuracy = compare(scene, run(integrator, scene, control), true_values);
      EXPECT_EQ(accuracy.missed + accuracy.spurious, 0) << integrator.name;
      return accuracy.impact_time_error.value_or(infinity);
    };
    const double tight = error(fixed(integrator) ? 1e-6 : 1e-11);
    EXPECT_LT(tight, 0.2 * error(loose)) << integrator.name;
    EXPECT_LT(tight, fixed(integrator) ? 1e-5 : 1e-9) << integrator.name;
  }
}

TEST(Penalty, MethodsEndWithAReasonWhateverTheControl) {
  Scene scene = compliant_gap();
  scene.stiffness = 1e16;
  for (const Integrator& integrator : through_walls()) {
    for (const double control : {1e-30, 1e-2, 1.0}) {
      const Outcome outcome = integrator.run(scene, control);
      EXPECT_NE(outcome.finished, !outcome.failure.empty()) << integrator.name << " " << control;
      EXPECT_TRUE(std::isfinite(outcome.end.position)) << integrator.name << " " << control;
      EXPECT_TRUE(std::isfinite(outcome.end.velocity)) << integrator.name << " " << control;
    }
  }
}

TEST(Penalty, StepsThatTheWallThrowsOutAreToldAsSuch) {
  Scene scene = compliant_gap();
  scene.stiffness = 1e16;
  for (const char* name : {"semi-implicit-euler", "runge-kutta-4"}) {
    const Outcome outcome = find_integrator(name).run(scene, 1e-3);
    EXPECT_FALSE(outcome.finished);
    EXPECT_EQ(outcome.failure, "the body has left the walls by more than the gap");
    EXPECT_EQ(outcome.deepest, infinity);
  }
}

/// A body of 1 kg on an elastic spring of 1 N/m, w = 1/s, that a force 1 - cos(0.01 t) N presses in
/// so slowly that it swings hardly at all: the depth is that force over 1 N/m, 2 m at most.
Scene pressed_slowly() {
  Scene scene = one_impact(ContactLaw::hertz, 1, 1);
  scene.start_position = 0;
  scene.start_velocity = 0;
  scene.pull = 1;
  scene.disturbance = 1;
  scene.disturbance_frequency = 0.01;
  scene.window = Seconds{350};
  return scene;
}

void expect_bound_on_a_spring(const char* name, const std::vector<double>& stable,
                              double unstable) {
  for (const double step : stable) {
    EXPECT_NEAR(run(find_integrator(name), pressed_slowly(), step).deepest, 2, 0.01)
        << name << " " << step;
  }
  EXPECT_GT(find_integrator(name).run(pressed_slowly(), unstable).deepest, 10) << name;
}

TEST(Penalty, SemiImplicitEulerStaysOnASpringUpToTwo) {
  expect_bound_on_a_spring("semi-implicit-euler", {0.5, 1, 1.8}, 2.2);
}

TEST(Penalty, RungeKutta4StaysOnASpringUpToTheRootOfEight) {
  expect_bound_on_a_spring("runge-kutta-4", {0.5, 1, 2.7}, 3.0);
}

TEST(Penalty, RungeKutta4GivesABouncingBodyEnergyAtThreeAndAHalfAndNotAtOne) {
  Scene scene = one_impact(ContactLaw::exact_restitution, 1, 0.9);
  scene.window = Seconds{35};
  for (int i = 0; i < 50; ++i) {
    scene.start_position = 0.3 + 0.02 * i;
    EXPECT_LT(*run(find_integrator("runge-kutta-4"), scene, 1.0).gained, 0) << i;
  }
  int gains = 0;
  for (int i = 0; i < 50; ++i) {
    scene.start_position = 0.3 + 0.07 * i;
    const Outcome outcome = find_integrator("runge-kutta-4").run(scene, 3.5);
    gains += outcome.gained.value_or(0) > 0 || !outcome.finished;
  }
  EXPECT_GT(gains, 10);
}

TEST(Penalty, SemiImplicitEulerThrowsABodyOutOfALinearWallByTheClosedForm) {
  // A step that ends d = u h v deep, 0 < u <= 1, is followed by one that leaves with
  // v (w^2 h^2 u - 1) where that lifts it out: u (w^2 h^2 - 1) > 1. With h w = 1.8, u = 0.9: 1.916.
  Scene scene = one_impact(ContactLaw::hertz, 1, 1);
  const double h = 1.8, u = 0.9;
  scene.start_position = 2 * h - u * h;
  scene.window = Seconds{20 * h};
  const Outcome outcome = run(find_integrator("semi-implicit-euler"), scene, h);
  EXPECT_NEAR(outcome.end.velocity, h * h * u - 1, 1e-12);
  EXPECT_NEAR(*outcome.gained, h * h * u - 2, 1e-12);
  EXPECT_NEAR(outcome.deepest, u * h, 1e-12);
}

TEST(Penalty, ExplicitErrorControlPaysForRestOnAStiffWall) {
  // Ten thousand times the stiffness is, with the frequency ~ K^(1/3) of a pressed Hertz contact,
  // 21.5 times the steps for a method that is bound by stability.
  const auto evaluations = [](const char* name, double stiffness) {
    const Outcome outcome =
        run(find_integrator(name), resting_body(ContactLaw::exact_restitution, stiffness), 1e-6);
    return static_cast<double>(outcome.force_evaluations);
  };
  const double growth = evaluations("odeint-dopri5", 1e14) / evaluations("odeint-dopri5", 1e10);
  EXPECT_GT(growth, 10);
  EXPECT_LT(growth, 40);
  EXPECT_LT(3 * evaluations("odeint-rosenbrock4", 1e16), evaluations("odeint-dopri5", 1e16));
}

TEST(Penalty, OnlyTheRosenbrockMethodSettlesToRoundingOnAStiffWall) {
  const Scene scene = resting_body(ContactLaw::exact_restitution, 1e14);
  const double depth = std::pow(10 / 1e14, 2.0 / 3);
  const auto error = [&](const char* name) {
    return std::abs(-run(find_integrator(name), scene, 1e-6).end.position / depth - 1);
  };
  EXPECT_LT(error("event-driven"), 1e-9);
  EXPECT_LT(error("odeint-rosenbrock4"), 1e-9);
  EXPECT_GT(error("odeint-dopri5"), 1e-6);
}

TEST(Penalty, BdfRestsInAStiffViscousWallForMuchLessThanAdams) {
  // w = 3.2e6 1/s: explicit and fixed-point iterations must follow it for ever.
  const Scene scene = resting_body(ContactLaw::kelvin_voigt, 1e13);
  const Outcome bdf = run(find_integrator("cvode-bdf"), scene, 1e-6);
  const Outcome adams = find_integrator("cvode-adams").run(scene, 1e-6);
  EXPECT_LT(20 * bdf.force_evaluations, adams.force_evaluations);
}

}  // namespace
}  // namespace ricochet::carrier_track
