#include "problems/carrier_track/scene/scene_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/error.h"
#include "tests/support/numbers.h"

namespace ricochet::carrier_track {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::string complaint_about(const Scene& scene) {
  try {
    check(scene, "machine");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(SceneCheck, AcceptsTheDefaultsTheDefaultMachineAndRandomScenes) {
  EXPECT_NO_THROW(check(Scene{}, "machine"));
  EXPECT_NO_THROW(check(default_machine(), "default machine"));
  RandomScenes scenes(31);
  for (int i = 0; i < 1000; ++i) EXPECT_NO_THROW(check(scenes.next(), "machine"));
  for (int i = 0; i < 1000; ++i) EXPECT_NO_THROW(check(scenes.next_planar(), "machine"));
}

TEST(SceneCheck, AcceptsTheEdgesOfEveryRange) {
  Scene scene;
  scene.wall_upper = infinity;
  scene.restitution_lower = 0;
  scene.start_position = 0;
  scene.omega = 0;
  scene.disturbance_frequency = 0;
  scene.pull = -1e15;
  scene.disturbance = 1e15;
  scene.mass = scene.counting_limit = 1e-15;
  EXPECT_EQ(complaint_about(scene), "accepted");
  scene.wall_upper = scene.start_position = 1;
  EXPECT_EQ(complaint_about(scene), "accepted");
}

TEST(SceneCheck, AllowsFrictionInContactWhereItLeavesSomething) {
  Scene scene;
  scene.friction = 1.5;
  EXPECT_EQ(complaint_about(scene), "accepted");
  scene.contact_friction = true;
  EXPECT_THAT(complaint_about(scene), HasSubstr("scene.friction = 1.5: must be within 0..1"));
  scene.friction = 1;
  EXPECT_EQ(complaint_about(scene), "accepted");
  scene.across.emplace();
  EXPECT_THAT(complaint_about(scene), HasSubstr("scene.contact_friction = 1: must be false"));
}

struct Wrong {
  double Scene::*field;
  std::string key;
  std::string allowed;
  std::vector<double> values;
};

TEST(SceneCheck, NamesEveryFieldOutOfItsRange) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  for (const Wrong& wrong : {
           Wrong{&Scene::mass, "scene.mass", "> 0 [kg]", {0, -1, infinity, nan}},
           Wrong{&Scene::wall_lower, "scene.wall_lower", "finite", {-infinity, nan}},
           Wrong{&Scene::wall_upper, "scene.wall_upper", "> wall_lower = 0", {0, -1, nan}},
           Wrong{&Scene::restitution_lower, "scene.restitution", "0..1", {-tiny, 1.0001, nan}},
           Wrong{&Scene::restitution_upper, "scene.restitution", "0..1", {-tiny, 1.0001, nan}},
           Wrong{&Scene::friction, "scene.friction", ">= 0", {-tiny, infinity, nan}},
           Wrong{&Scene::normal_force, "scene.normal_force", ">= 0", {-tiny, infinity, nan}},
           Wrong{&Scene::pull, "scene.pull", "finite", {infinity, -infinity, nan}},
           Wrong{&Scene::pull_phase, "scene.pull_phase", "finite", {infinity, nan}},
           Wrong{&Scene::disturbance_phase, "scene.disturbance_phase", "finite", {infinity, nan}},
           Wrong{&Scene::centrifugal_mass_radius,
                 "scene.centrifugal_mass_radius",
                 ">= 0",
                 {-tiny, infinity, nan}},
           Wrong{&Scene::slider_mass_radius,
                 "scene.slider_mass_radius",
                 ">= 0",
                 {-tiny, infinity, nan}},
           Wrong{&Scene::phase, "scene.phase", "finite", {infinity, nan}},
           Wrong{&Scene::disturbance, "scene.disturbance", "finite", {infinity, nan}},
           Wrong{&Scene::disturbance_frequency,
                 "scene.disturbance_frequency",
                 ">= 0",
                 {-tiny, infinity, nan}},
           Wrong{&Scene::start_position, "scene.start_position", "0..1", {-tiny, 1.01, nan}},
           Wrong{&Scene::start_velocity, "scene.start_velocity", "finite", {infinity, nan}},
           Wrong{&Scene::omega, "scene.omega", ">= 0", {-tiny, infinity, nan}},
           Wrong{&Scene::counting_limit, "count.counting_limit", "> 0", {0, -1, infinity, nan}},
           Wrong{&Scene::peak_high, "count.peak_high", "> 0", {0, -1, infinity, nan}},
           Wrong{&Scene::peak_low, "count.peak_low", "> 0", {0, -1, infinity, nan}},
           Wrong{&Scene::stiffness, "model.stiffness", "> 0", {0, -1, infinity, nan}},
           Wrong{&Scene::contact_exponent, "model.contact_exponent", "> 0", {0, -1, infinity, nan}},
       }) {
    for (const double value : wrong.values) {
      Scene scene;
      scene.*wrong.field = value;
      const std::string message = complaint_about(scene);
      EXPECT_THAT(message, StartsWith("machine: " + wrong.key + " = "));
      EXPECT_THAT(message, HasSubstr("must be"));
      EXPECT_THAT(message, HasSubstr(wrong.allowed)) << value;
    }
  }
}

struct WrongAcross {
  double Across<double>::*field;
  std::string key;
  std::string allowed;
  std::vector<double> values;
};

TEST(SceneCheck, NamesEveryFieldOfTheSecondDirectionOutOfItsRange) {
  using Y = Across<double>;
  const double tiny = std::numeric_limits<double>::denorm_min();
  for (const WrongAcross& wrong : {
           WrongAcross{&Y::pull, "across.pull", "finite", {infinity, -infinity, nan}},
           WrongAcross{&Y::wall_lower, "across.wall_lower", "finite", {-infinity, nan}},
           WrongAcross{&Y::wall_upper, "across.wall_upper", "> wall_lower = 0", {0, -1, nan}},
           WrongAcross{&Y::restitution_lower, "across.restitution", "0..1", {-tiny, 1.0001, nan}},
           WrongAcross{&Y::restitution_upper, "across.restitution", "0..1", {-tiny, 1.0001, nan}},
           WrongAcross{&Y::start_position, "across.start_position", "0..1", {-tiny, 1.01, nan}},
           WrongAcross{&Y::start_velocity, "across.start_velocity", "finite", {infinity, nan}},
       }) {
    for (const double value : wrong.values) {
      Scene scene;
      scene.across.emplace().*wrong.field = value;
      const std::string message = complaint_about(scene);
      EXPECT_THAT(message, StartsWith("machine: " + wrong.key + " = "));
      EXPECT_THAT(message, HasSubstr(wrong.allowed)) << value;
    }
  }
}

TEST(SceneCheck, NeedsASecondDirectionForFidelityPlanarAlone) {
  Scene scene;
  scene.fidelity = Fidelity::planar;
  EXPECT_THAT(complaint_about(scene), HasSubstr("[across]"));
  scene.across.emplace();
  EXPECT_EQ(complaint_about(scene), "accepted");
  scene.fidelity = Fidelity::impact;
  EXPECT_EQ(complaint_about(scene), "accepted");
}

TEST(SceneCheck, RefusesAPullAcrossBesideOneThatTurnsThere) {
  Scene scene;
  scene.pull_rotates = true;
  scene.across.emplace();
  EXPECT_EQ(complaint_about(scene), "accepted");
  scene.across->pull = 1;
  EXPECT_THAT(complaint_about(scene), StartsWith("machine: across.pull = 1: must be 0"));
}

TEST(SceneCheck, RefusesAContactSpeedThatIsNone) {
  for (const double speed : {0.0, -1.0, infinity, nan}) {
    Scene scene;
    scene.contact_speed = speed;
    EXPECT_THAT(complaint_about(scene), StartsWith("machine: model.contact_speed = "));
  }
}

TEST(SceneCheck, RefusesARestitutionThatTheContactLawCannotReturn) {
  Scene scene;
  scene.contact_exponent = 1;
  for (double Scene::*wall : {&Scene::restitution_lower, &Scene::restitution_upper}) {
    scene.restitution_lower = scene.restitution_upper = 0.5;
    scene.*wall = 0;
    for (const ContactLaw law : {ContactLaw::kelvin_voigt, ContactLaw::flores, ContactLaw::gonthier,
                                 ContactLaw::exact_restitution}) {
      scene.contact_law = law;
      scene.fidelity = Fidelity::compliant;
      EXPECT_THAT(complaint_about(scene),
                  StartsWith("machine: scene.restitution = 0: must be at least 1e-6"));
      scene.fidelity = Fidelity::impact;
      EXPECT_EQ(complaint_about(scene), "accepted") << "the law is not used";
    }
    scene.fidelity = Fidelity::compliant;
    scene.contact_law = ContactLaw::hunt_crossley;
    EXPECT_EQ(complaint_about(scene), "accepted");
  }
}

TEST(SceneCheck, RefusesAFrictionThatLeavesTheContactLawNoRestitution) {
  Scene scene;
  scene.contact_friction = true;
  scene.contact_law = ContactLaw::flores;
  scene.friction = 1;
  EXPECT_EQ(complaint_about(scene), "accepted") << "the law is not used";
  for (const Fidelity level : {Fidelity::compliant, Fidelity::automatic}) {
    scene.fidelity = level;
    scene.friction = 1;
    EXPECT_THAT(complaint_about(scene),
                StartsWith("machine: scene.friction = 1: must be at most 0.999999, because"));
    scene.friction = 0.999999;
    EXPECT_EQ(complaint_about(scene), "accepted");
    EXPECT_NO_THROW(record(scene, 0.25, 0));
  }
}

TEST(SceneCheck, RefusesNumbersFarBeyondAnyMachine) {
  for (double Scene::*field : {&Scene::mass,
                               &Scene::wall_lower,
                               &Scene::wall_upper,
                               &Scene::friction,
                               &Scene::normal_force,
                               &Scene::pull,
                               &Scene::pull_phase,
                               &Scene::centrifugal_mass_radius,
                               &Scene::slider_mass_radius,
                               &Scene::phase,
                               &Scene::disturbance,
                               &Scene::disturbance_frequency,
                               &Scene::disturbance_phase,
                               &Scene::start_velocity,
                               &Scene::omega,
                               &Scene::counting_limit,
                               &Scene::peak_high,
                               &Scene::peak_low,
                               &Scene::stiffness,
                               &Scene::contact_exponent}) {
    Scene scene;
    scene.*field = 1e16;
    EXPECT_THAT(complaint_about(scene), HasSubstr("1e+16: must be"));
  }
  for (double Scene::*field : {&Scene::mass, &Scene::counting_limit, &Scene::stiffness}) {
    Scene scene;
    scene.*field = 0.9e-15;
    EXPECT_THAT(complaint_about(scene), HasSubstr("within 1e-15..1e15"));
  }
}

/// No step of an integration is small enough for the jump of such a force.
TEST(SceneCheck, RefusesAContactThatIsInfinitelyStiffAtTheSurface) {
  Scene scene;
  scene.contact_exponent = 0.99;
  EXPECT_EQ(complaint_about(scene), "accepted") << "hard walls have no use for it";
  for (const Fidelity fidelity : {Fidelity::compliant, Fidelity::automatic}) {
    scene.fidelity = fidelity;
    scene.contact_exponent = 0.99;
    EXPECT_THAT(complaint_about(scene), HasSubstr("contact_exponent = 0.99: must be at least 1"));
    scene.contact_exponent = 1;
    EXPECT_EQ(complaint_about(scene), "accepted");
  }
}

TEST(SceneCheck, RefusesAWindowOfPeriodsWithoutNumber) {
  Scene scene;
  scene.window = Revolutions{1e6};
  EXPECT_EQ(complaint_about(scene), "accepted");
  scene.window = Revolutions{1.001e6};
  EXPECT_THAT(complaint_about(scene),
              StartsWith("machine: window.revolutions = 1001000: must be at most 1000000"));
  scene.window = Seconds{1e4};
  scene.disturbance_frequency = 1e9;
  EXPECT_EQ(complaint_about(scene), "accepted") << "nothing disturbs";
  scene.disturbance = 1;
  EXPECT_THAT(complaint_about(scene), HasSubstr("seconds = 10000: must be at most 0.0062831"));
  scene.disturbance = 0;
  scene.profile = {{0.0, 1.0}, {1.0, 700.0}, {2.0, 1.0}};
  EXPECT_THAT(complaint_about(scene), HasSubstr("of 700 rad/s"));
  scene.profile.clear();
  scene.omega = 1e-12;
  scene.window = Revolutions{1e5};
  EXPECT_THAT(complaint_about(scene), StartsWith("machine: window.revolutions = 100000: must be"));
  scene.window = Seconds{1e4};
  scene.omega = 1e3;
  EXPECT_THROW(check_omega(scene, "command line", "--omega"), InputError);
}

TEST(SceneCheck, RefusesKnotsThatAreOneButForRounding) {
  Scene scene;
  scene.profile = {{0.0, 1.0}, {1e-9, 9.0}};
  EXPECT_EQ(complaint_about(scene), "accepted");
  scene.profile[1].time = 1e-50;
  EXPECT_THAT(complaint_about(scene), StartsWith("machine: scene.omega's time = 1e-50: must be"));
}

TEST(SceneCheck, RefusesAnExponentThatKelvinVoigtDoesNotHave) {
  Scene scene;
  scene.fidelity = Fidelity::compliant;
  scene.contact_law = ContactLaw::kelvin_voigt;
  EXPECT_THAT(complaint_about(scene),
              StartsWith("machine: model.contact_exponent = 1.5: must be 1"));
  scene.contact_exponent = 1;
  EXPECT_EQ(complaint_about(scene), "accepted");
}

TEST(SceneCheck, NeverLetsABodyStartAtInfinity) {
  Scene scene;
  scene.wall_upper = scene.start_position = infinity;
  EXPECT_THAT(complaint_about(scene), StartsWith("machine: scene.start_position"));
}

TEST(SceneCheck, RefusesAnEmptyWindow) {
  for (const double count : {0.0, -1.0, infinity, nan}) {
    Scene scene;
    scene.window = Seconds{count};
    EXPECT_THAT(complaint_about(scene), StartsWith("machine: window.seconds = "));
    scene.window = Revolutions{count};
    EXPECT_THAT(complaint_about(scene), StartsWith("machine: window.revolutions = "));
  }
}

TEST(SceneCheck, NeedsASpeedForAWindowInRevolutions) {
  Scene scene;
  scene.omega = 0.0;
  EXPECT_NO_THROW(check_omega(scene, "command line", "--omega"));
  scene.window = Revolutions{1.0};
  try {
    check_omega(scene, "command line", "--omega");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), StartsWith("command line: --omega = 0: must be"));
    EXPECT_THAT(error.what(), HasSubstr("revolutions"));
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
