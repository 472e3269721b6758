#include "problems/carrier_track/motion/compliant_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/models/brute_force.h"
#include "tests/carrier_track/models/expect_close.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/scenes.h"
#include "tests/support/numbers.h"

namespace ricochet::carrier_track {
namespace {

using std::numbers::pi;

const std::vector<ContactLaw>& all_laws() {
  static const std::vector<ContactLaw> laws = {
      ContactLaw::hertz,          ContactLaw::kelvin_voigt,
      ContactLaw::hunt_crossley,  ContactLaw::lankarani_nikravesh,
      ContactLaw::zhiying_qishao, ContactLaw::flores,
      ContactLaw::gonthier,       ContactLaw::exact_restitution};
  return laws;
}

struct Pressed : Watched<double> {
  void contact(double time, double position, double velocity) {
    samples.push_back({time, position, velocity});
  }
  std::vector<Sample> samples;
};

Pressed press(const Scene& scene, double tolerance = 1e-10) {
  Pressed pressed;
  CompliantModel model(scene, tolerance);
  pressed.end = model.run(pressed);
  return pressed;
}

/// The same scene between hard walls.
auto watch_hard(Scene scene) {
  scene.fidelity = Fidelity::impact;
  return watch(scene);
}

/// A body without forces that strikes the lower wall at once.
Scene thrown(ContactLaw law, double restitution) {
  Scene scene;
  scene.fidelity = Fidelity::compliant;
  scene.mass = 1.2;
  scene.wall_upper = infinity;
  scene.start_position = 0;
  scene.start_velocity = -0.3;
  scene.restitution_lower = scene.restitution_upper = restitution;
  scene.contact_law = law;
  if (law == ContactLaw::kelvin_voigt) scene.contact_exponent = 1;
  scene.window = Seconds{0.2};
  return scene;
}

/// What theory says that a scene's law returns from an impact of a given speed.
double theoretical_restitution(const Scene& scene, double speed) {
  if (scene.contact_law == ContactLaw::kelvin_voigt) return scene.restitution_lower;
  const double factor = dissipation(scene.contact_law, scene.restitution_lower);
  return returned_restitution(factor * speed / scene.contact_speed.value_or(speed));
}

TEST(CompliantModel, ReturnsTheRestitutionOfEveryLawWhateverStiffnessMassAndExponent) {
  double worst = 0;
  for (const ContactLaw law : all_laws()) {
    for (const double c : {0.1, 0.3, 0.5, 0.7, 0.9}) {
      for (const double n : {1.0, 1.3, 1.5, 2.0}) {
        Scene scene = thrown(law, c);
        if (law != ContactLaw::kelvin_voigt) scene.contact_exponent = n;
        scene.stiffness = n < 1.4 ? 3e6 : 1e9;
        scene.mass = n == 2.0 ? 0.02 : 1.2;
        SCOPED_TRACE(testing::Message() << static_cast<int>(law) << " " << c << " " << n);
        const Pressed pressed = press(scene);
        ASSERT_EQ(pressed.hits.size(), 1U);
        const double e = pressed.end.velocity / 0.3;
        const double error = std::abs(e / theoretical_restitution(scene, 0.3) - 1);
        EXPECT_LT(error, 1e-8);
        worst = std::max(worst, error);
      }
    }
  }
  RecordProperty("worst_relative_error", std::to_string(worst));
}

TEST(CompliantModel, PenetratesAsDeepAsTheoryAndAppearsInBothWallsAlike) {
  for (const ContactLaw law : {ContactLaw::hertz, ContactLaw::hunt_crossley, ContactLaw::flores}) {
    for (const double c : {0.1, 0.6}) {
      Scene scene = thrown(law, c);
      const Pressed lower = press(scene);
      double depth = 0;
      for (const Sample& s : lower.samples) depth = std::max(depth, -s.position);
      expect_close(depth, peak_penetration(1e8, 1.5, 1.2, 0.3, dissipation(law, c)), 1e-9);
      EXPECT_TRUE(lower.tops.empty());

      scene.wall_lower = -infinity;
      scene.wall_upper = 0;
      scene.start_velocity = 0.3;
      const Pressed upper = press(scene);
      ASSERT_EQ(upper.samples.size(), lower.samples.size());
      for (std::size_t i = 0; i < upper.samples.size(); ++i) {
        EXPECT_EQ(upper.samples[i].position, -lower.samples[i].position);
        EXPECT_EQ(upper.samples[i].velocity, -lower.samples[i].velocity);
      }
      ASSERT_EQ(upper.tops.size(), 1U) << "the deepest place in the upper wall is a peak";
      EXPECT_EQ(upper.tops[0].position, depth);
    }
  }
}

TEST(CompliantModel, AHertzContactLastsItsClosedFormTimeAndKeepsItsEnergy) {
  for (const double n : {1.0, 1.5, 2.0}) {
    Scene scene = thrown(ContactLaw::hertz, 0.5);
    scene.contact_exponent = n;
    const Pressed pressed = press(scene);
    const double depth = peak_penetration(scene.stiffness, n, scene.mass, 0.3, 0);
    // 2 times the integral of dx / sqrt(1 - x^(n+1)) over 0..1, a beta function.
    const double a = 1 / (n + 1);
    const double lasts = 2 * std::sqrt(pi) * std::tgamma(1 + a) / std::tgamma(0.5 + a);
    if (n == 1.5) {
      EXPECT_NEAR(lasts, 2.94328, 5e-6);
    }
    ASSERT_EQ(pressed.stretches.size(), 2U);
    expect_close(pressed.stretches[1].time, lasts * depth / 0.3, 1e-9);
    for (const Sample& s : pressed.samples) {
      const double energy = 0.5 * scene.mass * s.velocity * s.velocity +
                            scene.stiffness * std::pow(-s.position, n + 1) / (n + 1);
      expect_close(energy, 0.5 * scene.mass * 0.09, 1e-9);
    }
  }
}

TEST(CompliantModel, FollowsALinearSpringUnderAPullThatTurns) {
  // x'' = -w^2 x - P cos(W t) while x < 0: x = c (cos(W t) - cos(w t)) + v0/w sin(w t), where
  // c = -P / (w^2 - W^2).
  for (const double turning : {4.0, 40.0, 3000.0}) {
    Scene scene = thrown(ContactLaw::hertz, 0.5);
    scene.contact_exponent = 1;
    scene.stiffness = 1.2e4;  // w = 100 rad/s
    scene.pull = 1.2 * 3.0 * (turning > 100 ? 1000 : 1);
    scene.pull_rotates = true;
    scene.omega = turning;
    const Pressed pressed = press(scene);
    ASSERT_GE(pressed.samples.size(), 5U);
    const double c = -scene.pull / 1.2 / (1e4 - turning * turning);
    for (const Sample& s : pressed.samples) {
      if (s.time > 0.027) break;
      const double x = c * (std::cos(turning * s.time) - std::cos(100 * s.time)) -
                       0.003 * std::sin(100 * s.time);
      EXPECT_NEAR(s.position, x, 3e-9 * 3e-3) << s.time;
    }
  }
}

TEST(CompliantModel, KelvinVoigtNeverPulls) {
  // The velocity may fall in the wall only while K d + C d' > 0: it never falls on the way out.
  for (const double c : {0.1, 0.5, 0.9}) {
    const Pressed pressed = press(thrown(ContactLaw::kelvin_voigt, c));
    double last = -1;
    for (const Sample& s : pressed.samples) {
      EXPECT_GE(s.velocity, last - 1e-11);
      last = s.velocity;
    }
    expect_close(pressed.end.velocity, 0.3 * c, 1e-9);
  }
}

TEST(CompliantModel, AFixedContactSpeedMakesSlowImpactsElastic) {
  // Then D v / v0 takes the place of D: that of the law only where v = v0.
  Scene scene = thrown(ContactLaw::exact_restitution, 0.1);
  scene.contact_speed = 0.3;
  double last = 0;
  for (const double speed : {0.6, 0.3, 0.03, 3e-3, 3e-4}) {
    scene.start_velocity = -speed;
    scene.window = Seconds{0.2 / speed};
    const double e = press(scene).end.velocity / speed;
    expect_close(e, theoretical_restitution(scene, speed), 1e-8);
    EXPECT_GT(e, last);
    last = e;
    if (speed == 0.3) {
      expect_close(e, 0.1, 1e-8);
    }
  }
  EXPECT_GT(last, 0.99);
}

TEST(CompliantModel, EachWallHasItsOwnRestitution) {
  Scene scene = thrown(ContactLaw::exact_restitution, 0.5);
  scene.restitution_upper = 0.9;
  scene.wall_upper = 0.01;
  scene.start_position = 0.005;
  scene.window = Seconds{1.0};
  const Pressed pressed = press(scene);
  ASSERT_GE(pressed.hits.size(), 5U);
  double speed = 0.3;
  for (const auto& hit : pressed.hits) {
    expect_close(hit.speed, speed, 1e-8);
    speed *= hit.wall == Wall::lower ? 0.5 : 0.9;
  }
}

TEST(CompliantModel, ErrsByNoMoreThanItsToleranceAndRepeatsItself) {
  for (const double n : {1.0, 1.3, 1.5}) {
    Scene scene = thrown(ContactLaw::exact_restitution, 0.3);
    scene.contact_exponent = n;
    double coarse = 0;
    for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
      const double error = std::abs(press(scene, tolerance).end.velocity / 0.09 - 1);
      EXPECT_LT(error, 3 * tolerance) << n;
      EXPECT_GT(error, 1e-4 * tolerance) << "a tolerance that is not used";
      if (tolerance == 1e-4) coarse = error;
      if (tolerance == 1e-12) {
        EXPECT_NEAR(std::log10(coarse / error) / 8, 1, 0.2) << "first order in the tolerance";
      }
    }
    EXPECT_EQ(press(scene).end.velocity, press(scene).end.velocity);
  }
}

TEST(CompliantModel, SpendsFewEvaluationsOnAContact) {
  Scene scene = thrown(ContactLaw::hunt_crossley, 0.5);
  EXPECT_LT(press(scene, 1e-6).end.evaluations, 400);
  EXPECT_LT(press(scene, 1e-10).end.evaluations, 800);
}

/// A ball dropped on a compliant floor, with the stiffness it takes for some depth.
Scene bouncing_ball(double stiffness) {
  Scene scene = thrown(ContactLaw::exact_restitution, 0.8);
  scene.stiffness = stiffness;
  scene.start_position = 0.5;
  scene.start_velocity = 0;
  scene.pull = 9.8;
  scene.mass = 1.0;
  scene.window = Seconds{2.0};
  return scene;
}

TEST(CompliantModel, ABouncingBallTendsToTheImpactModelAsTheContactTimeDoes) {
  // Contact times, and the weight's share of the rebound, fall with K^(-1/(n+1)).
  std::vector<double> errors;
  for (const double stiffness : {1e6, 1e8, 1e10, 1e12}) {
    const Scene scene = bouncing_ball(stiffness);
    const auto hard = watch_hard(scene);
    const Pressed soft = press(scene);
    ASSERT_GT(soft.hits.size(), 4U);
    errors.push_back(std::abs(soft.hits[4].time - hard.hits[4].time));
  }
  for (std::size_t i = 1; i < errors.size(); ++i) {
    EXPECT_NEAR(std::log10(errors[i - 1] / errors[i]) / 2, 0.4, 0.02);
  }
  EXPECT_LT(errors.back(), 1e-4);
}

TEST(CompliantModel, ABouncingBallEndsAtTheDepthThatCarriesItWithoutTinySteps) {
  for (const double c : {0.1, 0.5, 0.9}) {
    Scene scene = bouncing_ball(1e10);
    scene.restitution_lower = c;
    scene.window = Seconds{60.0};
    const Pressed minute = press(scene);
    expect_close(minute.end.position, -std::pow(9.8 / 1e10, 1 / 1.5), 1e-8);
    EXPECT_NEAR(minute.end.velocity, 0, 1e-9);
    EXPECT_EQ(minute.end.time, 60.0);
    scene.window = Seconds{6e4};
    EXPECT_LE(press(scene).samples.size(), minute.samples.size() + 30);
  }
}

TEST(CompliantModel, RestsInTheWallItIsPressedAgainstFromTheStart) {
  for (const ContactLaw law : all_laws()) {
    for (const double mu : {0.0, 0.2}) {
      for (int i = 1; i <= 20; ++i) {
        Scene scene = thrown(law, 0.5);
        scene.start_velocity = 0;
        scene.pull = 0.37 * i;
        scene.friction = mu;
        scene.normal_force = 1.0;
        const Pressed pressed = press(scene);
        EXPECT_TRUE(pressed.hits.empty());
        EXPECT_TRUE(pressed.samples.empty()) << "it takes no steps";
        expect_close(pressed.end.position,
                     -std::pow((scene.pull - mu) / scene.stiffness, 1 / scene.contact_exponent),
                     1e-12);
      }
    }
  }
}

TEST(CompliantModel, SinksIntoAWallWhenAGrowingForceOvercomesFriction) {
  for (const double mu : {0.0, 0.25}) {
    Scene scene = thrown(ContactLaw::exact_restitution, 0.5);
    scene.stiffness = 1e10;
    scene.start_velocity = 0;
    scene.pull = 2.0;
    scene.pull_rotates = true;
    scene.phase = -pi / 2;  // 2 sin(3 t), inward
    scene.omega = 3.0;
    scene.friction = mu;
    scene.normal_force = 4.0;
    scene.window = Seconds{0.4};
    const Pressed pressed = press(scene);
    ASSERT_FALSE(pressed.samples.empty());
    EXPECT_NEAR(pressed.samples.front().time, std::asin(mu * 4.0 / 2.0) / 3.0, 1e-3);
    // Slowly enough to carry the force at every depth.
    const double force = 2.0 * std::sin(1.2) - mu * 4.0;
    expect_close(pressed.end.position, -std::pow(force / 1e10, 1 / 1.5), 1e-2);
    EXPECT_LT(pressed.samples.size(), 2000U);
  }
}

TEST(CompliantModel, ATouchWithoutSpeedNeitherBouncesNorCreeps) {
  // Dropped from 1e-21 m it arrives with 1.3e-10 m/s, and rests where the wall carries it; the
  // printed law, scaled with that speed, would let it sink for hours.
  Scene scene = thrown(ContactLaw::exact_restitution, 0.1);
  scene.start_position = 1e-21;
  scene.start_velocity = 0;
  scene.pull = 10.0;
  const Pressed touch = press(scene);
  EXPECT_EQ(touch.hits.size(), 1U);
  expect_close(touch.end.position, -std::pow(10.0 / 1e8, 1 / 1.5), 1e-12);
}

TEST(CompliantModel, HopsTooSlowToMatterEnd) {
  // 1e-7 N would let it hop at picometres per second for hundreds of contacts.
  Scene scene = thrown(ContactLaw::exact_restitution, 0.9);
  scene.mass = 1.0;
  scene.stiffness = 1e14;
  scene.pull = 1e-7;
  scene.start_position = 7e-12;
  scene.start_velocity = 0;
  scene.window = Seconds{100.0};
  const Pressed hops = press(scene);
  EXPECT_GE(hops.hits.size(), 2U);
  EXPECT_LE(hops.hits.size(), 4U);
  expect_close(hops.end.position, -std::pow(1e-7 / 1e14, 1 / 1.5), 1e-12);
}

TEST(CompliantModel, RestsOnTheSurfaceOfAWallThatNothingPressesIt) {
  Scene scene = thrown(ContactLaw::hunt_crossley, 0.5);
  scene.start_velocity = 0;
  scene.friction = 0.5;
  scene.normal_force = 3.0;
  scene.pull = 1.4;
  EXPECT_EQ(press(scene).end.position, 0.0);
  scene.pull = 0;
  scene.friction = 0;
  EXPECT_EQ(press(scene).end.position, 0.0);
}

TEST(CompliantModel, FrictionInAWallTakesItsTollOfEveryHalfTurnOfALinearSpring) {
  // About the depth P / w^2, every turning point is 2 f / w^2 nearer, until friction holds it.
  Scene scene = thrown(ContactLaw::hertz, 1.0);
  scene.contact_exponent = 1;
  scene.mass = 1.0;
  scene.stiffness = 1e4;
  scene.pull = 50.0;
  scene.friction = 0.3;
  scene.normal_force = 8.0;  // f = 2.4, shift 4.8e-4 m
  scene.start_velocity = -0.15;
  scene.window = Seconds{3.0};
  const Pressed pressed = press(scene);
  // The first turn follows from the energy: w^2 d^2 / 2 - (P - f) d = v^2 / 2.
  const double net = 50.0 - 2.4;
  double depth = (net + std::sqrt(net * net + 1e4 * 0.15 * 0.15)) / 1e4;
  std::vector<double> turns;
  for (const Sample& s : pressed.samples) {
    if (s.velocity == 0) turns.push_back(-s.position);
  }
  double away = depth - 50.0 / 1e4;
  double expected = depth;
  std::size_t k = 0;
  for (;; ++k) {
    ASSERT_LT(k, turns.size());
    expect_close(turns[k], expected, 1e-9);
    if (std::abs(away) <= 2.4e-4) break;
    away = -away + (away > 0 ? 1 : -1) * 4.8e-4;
    expected = 50.0 / 1e4 + away;
  }
  EXPECT_GE(k, 5U);
  EXPECT_EQ(turns.size(), k + 1);
  EXPECT_EQ(pressed.end.velocity, 0.0);
  EXPECT_EQ(-pressed.end.position, turns.back());
}

TEST(CompliantModel, HoldsABodyInTheWallUntilTheBalanceLeavesTheBandOfFriction) {
  // It rests where the wall carries pull - friction; it slips when the pull has fallen by twice
  // the friction.
  for (const double stiffness : {1e5, 1e8, 1e12}) {
    Scene scene = thrown(ContactLaw::exact_restitution, 0.5);
    scene.stiffness = stiffness;
    scene.start_velocity = 0;
    scene.pull = 2.0;
    scene.pull_rotates = true;
    scene.omega = 3.0;
    scene.friction = 0.25;
    scene.normal_force = 2.0;
    scene.window = Seconds{0.7};
    const Pressed pressed = press(scene);
    ASSERT_GE(pressed.stretches.size(), 1U);
    expect_close(pressed.stretches[0].duration, std::acos((2.0 - 2 * 0.5) / 2.0) / 3.0, 1e-9);
    // And leaves the wall when the pull has turned against friction.
    const auto& flight = pressed.stretches.back();
    EXPECT_NEAR(flight.time, std::acos(-0.5 / 2.0) / 3.0, 3 * std::pow(stiffness, -1.0 / 3));
  }
}

TEST(CompliantModel, LeavesTheWallWhenAPullThatTurnsNoLongerPresses) {
  // The impact model leaves at once when the pull has turned; the contact takes its own time.
  std::vector<double> delays;
  for (const double stiffness : {1e8, 1e10, 1e12, 1e14}) {
    Scene scene = thrown(ContactLaw::exact_restitution, 0.5);
    scene.stiffness = stiffness;
    scene.start_position = 1e-3;
    scene.start_velocity = 0;
    scene.pull = 1.0;
    scene.pull_rotates = true;
    scene.omega = 1.0;
    scene.window = Seconds{2.0};
    const Pressed pressed = press(scene);
    delays.push_back(pressed.stretches.back().time - pi / 2);
    EXPECT_GT(delays.back(), 0);
    EXPECT_LT(pressed.samples.size(), 600U);
    EXPECT_NEAR(pressed.end.position, watch_hard(scene).end.position, 0.03 * delays.back());
  }
  EXPECT_LT(delays.front(), 4e-3);
  for (std::size_t i = 1; i < delays.size(); ++i) EXPECT_LT(delays[i], 0.4 * delays[i - 1]);
}

TEST(CompliantModel, CountsAsTheImpactModelWhereWallsAreVeryStiff) {
  int compared = 0;
  for (const Case& a_case : all_cases()) {
    for (const bool loud : {false, true}) {
      Scene scene = scene_of(a_case, exploratory_scene());
      scene.contact_law = ContactLaw::exact_restitution;
      scene.stiffness = 1e18;
      if (a_case.claim.figure) {
        scene.omega = loud ? a_case.claim.figure->loud : a_case.claim.figure->quiet;
      }
      const Recording hard = record(scene, 0.25, 0);
      if (!hard.certainty.certain || hard.certainty.margin.value_or(1.0) < 0.01) continue;
      const Pressed soft = press(scene);
      const auto count = std::count_if(soft.hits.begin(), soft.hits.end(), [&](const auto& hit) {
        return hit.speed > scene.counting_limit;
      });
      EXPECT_EQ(count, hard.count) << a_case.id << " at " << scene.omega;
      EXPECT_LT(soft.samples.size(), 6000U) << a_case.id << " at " << scene.omega;
      ++compared;
    }
  }
  EXPECT_GE(compared, 18);
}

/// A random law, stiffness and exponent for a random scene.
void make_compliant(Scene& scene, RandomScenes& draws) {
  scene.fidelity = Fidelity::compliant;
  scene.contact_law = all_laws()[static_cast<std::size_t>(draws.within(0, 7.999))];
  scene.contact_exponent = draws.chance(0.5) ? 1.5 : draws.within(1.0, 2.5);
  if (scene.contact_law == ContactLaw::kelvin_voigt) scene.contact_exponent = 1;
  scene.stiffness = draws.log_within(1e4, 1e9);
  if (draws.chance(0.2)) scene.contact_speed = draws.log_within(0.01, 1.0);
  scene.restitution_lower = std::max(scene.restitution_lower, 0.05);
  scene.restitution_upper = std::max(scene.restitution_upper, 0.05);
}

double elastic_energy(const Scene& scene, double depth) {
  return depth <= 0 ? 0
                    : scene.stiffness / (scene.contact_exponent + 1) *
                          std::pow(depth, scene.contact_exponent + 1);
}

double depth_in_walls(const Scene& scene, double position) {
  return std::max(scene.wall_lower - position, position - scene.wall_upper);
}

TEST(CompliantModel, NeverGainsEnergyUnderASteadyPull) {
  RandomScenes scenes(21);
  for (int i = 0; i < 2000; ++i) {
    Scene scene = scenes.next();
    make_compliant(scene, scenes);
    scene.omega = 0;
    scene.pull_rotates = false;
    scene.disturbance = 0;
    scene.window = Seconds{0.5};
    SCOPED_TRACE(i);
    ASSERT_NO_THROW(check(scene, "random"));
    const Pressed pressed = press(scene);
    const auto energy = [&](double position, double velocity) {
      return 0.5 * scene.mass * velocity * velocity + scene.pull * (position - scene.wall_lower) +
             elastic_energy(scene, depth_in_walls(scene, position));
    };
    double last = energy(scene.start_position, scene.start_velocity);
    double level = 0;  // what the energy is the sum of, for its rounding and the steps' errors
    for (const Sample& s : pressed.samples) {
      const double now = energy(s.position, s.velocity);
      level = std::max({level, std::abs(last), std::abs(now),
                        0.5 * scene.mass * s.velocity * s.velocity,
                        std::abs(scene.pull * (s.position - scene.wall_lower))});
      ASSERT_LE(now - last, 3e-9 * level) << s.time;
      last = now;
    }
  }
}

TEST(CompliantModel, StaysWithinTheDepthThatItsEnergyAllowsInRandomScenes) {
  RandomScenes scenes(22);
  std::size_t contacts = 0;
  for (int i = 0; i < 2000; ++i) {
    Scene scene = scenes.next();
    make_compliant(scene, scenes);
    SCOPED_TRACE(i);
    const Pressed pressed = press(scene);
    const double square = scene.omega * scene.omega;
    const double force = std::abs(scene.pull) + std::abs(scene.disturbance) +
                         square * (scene.centrifugal_mass_radius + scene.slider_mass_radius);
    double fastest = std::abs(scene.start_velocity);
    for (const auto& hit : pressed.hits) fastest = std::max(fastest, hit.speed);
    for (const Sample& s : pressed.samples) {
      const double depth = depth_in_walls(scene, s.position);
      ASSERT_LE(elastic_energy(scene, depth),
                0.5 * scene.mass * fastest * fastest + force * depth + 1e-12);
      ASSERT_GE(depth, -1e-15);
    }
    for (std::size_t k = 1; k < pressed.samples.size(); ++k) {
      ASSERT_GE(pressed.samples[k].time, pressed.samples[k - 1].time);
    }
    EXPECT_GE(pressed.end.time, 0.29);
    contacts += pressed.hits.size();
  }
  EXPECT_GT(contacts, 10'000U);
}

TEST(CompliantModel, RestsOnAWallWhereTheForcesBalanceFrictionButForRounding) {
  for (int i = 1; i < 30; ++i) {
    for (int k = 1; k < 30; ++k) {
      Scene scene = thrown(ContactLaw::hunt_crossley, 0.5);
      scene.start_velocity = 0;
      scene.omega = 0;
      scene.pull = 0.1 * i;
      scene.disturbance = -0.1 * k;
      scene.disturbance_frequency = 0;
      scene.friction = 0.1;
      scene.normal_force = i + k;
      const Pressed pressed = press(scene);
      EXPECT_EQ(pressed.end.position, 0.0);
      EXPECT_EQ(pressed.stretches.size(), 1U);
      scene.start_position = 0.5;
      EXPECT_EQ(press(scene).end.position, 0.5);
    }
  }
}

struct State {
  double depth, speed;
};

/// Classical Runge-Kutta steps in plain time through one contact with the lower wall, without
/// friction: a slow reference that shares only the law's formula. Its error, by the edges of the
/// contact, falls with the step's power n + 1.
class Reference {
 public:
  Reference(const Scene& scene, double time, double speed)
      : scene_(scene), time_(time), state_{0, speed} {
    damping_ = dissipation(scene.contact_law, scene.restitution_lower) /
               scene.contact_speed.value_or(speed);
  }

  /// Returns the time at which the body leaves the wall.
  double leave(double step) {
    for (;;) {
      const State a = derivative(0, {0, 0}, 0);
      const State b = derivative(step / 2, a, step / 2);
      const State c = derivative(step / 2, b, step / 2);
      const State d = derivative(step, c, step);
      const double depth =
          state_.depth + step * (a.depth + 2 * b.depth + 2 * c.depth + d.depth) / 6;
      const double speed =
          state_.speed + step * (a.speed + 2 * b.speed + 2 * c.speed + d.speed) / 6;
      if (depth < 0) {
        const double share = state_.depth / (state_.depth - depth);
        state_.speed += share * (speed - state_.speed);
        return time_ + share * step;
      }
      state_ = {depth, speed};
      time_ += step;
    }
  }
  double speed() const { return state_.speed; }

 private:
  State derivative(double later, State slope, double share) const {
    const double depth = std::max(0.0, state_.depth + share * slope.depth);
    const double speed = state_.speed + share * slope.speed;
    const double contact =
        scene_.stiffness * std::pow(depth, scene_.contact_exponent) * (1 + damping_ * speed);
    return {speed, (-force_of_plate(scene_, time_ + later) - contact) / scene_.mass};
  }

  const Scene& scene_;
  double time_;
  State state_;
  double damping_;
};

TEST(CompliantModel, PlainTimeStepsFindTheEndOfContactsUnderAllForces) {
  RandomScenes scenes(23);
  int compared = 0;
  for (int i = 0; i < 300; ++i) {
    Scene scene = scenes.next();
    make_compliant(scene, scenes);
    if (scene.contact_law == ContactLaw::kelvin_voigt) continue;
    scene.friction = 0;
    scene.stiffness = 3e6;
    const Pressed pressed = press(scene);
    if (pressed.hits.empty() || pressed.hits[0].wall != Wall::lower) continue;
    const auto& hit = pressed.hits[0];
    const auto end = std::find_if(
        pressed.samples.begin(), pressed.samples.end(),
        [&](const Sample& s) { return s.time > hit.time && s.position == scene.wall_lower; });
    if (end == pressed.samples.end() || end->time > hit.time + 0.03) continue;
    SCOPED_TRACE(i);
    Reference reference(scene, hit.time, hit.speed);
    const double lasts = reference.leave((end->time - hit.time) / 3000) - hit.time;
    EXPECT_NEAR(lasts / (end->time - hit.time), 1, 3e-5);
    EXPECT_NEAR(-reference.speed() / end->velocity, 1, 3e-5);
    ++compared;
  }
  EXPECT_GT(compared, 60);
}

TEST(CompliantModel, EndsWhereverItsWindowDoesInAContact) {
  Scene scene = thrown(ContactLaw::hertz, 0.5);
  scene.contact_exponent = 1;
  scene.stiffness = 1.2e4;  // w = 100 rad/s
  for (int i = 1; i < 314; ++i) {
    const double end = 1e-4 * i;
    scene.window = Seconds{end};
    const Pressed pressed = press(scene);
    EXPECT_EQ(pressed.end.time, end);
    EXPECT_NEAR(pressed.end.position, -0.003 * std::sin(100 * end), 1e-9 * 0.003);
    EXPECT_NEAR(pressed.end.velocity, -0.3 * std::cos(100 * end), 1e-9 * 0.3);
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
