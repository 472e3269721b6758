#include "problems/carrier_track/motion/compliant_model.h"

#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "ricochet/machine.h"
#include "tests/carrier_track/models/brute_force.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

using std::numbers::pi;

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

/// A body without forces that strikes the lower wall at once.
Scene thrown(ContactLaw law, double restitution) {
  return with(
      Scene{}, set::fidelity(Fidelity::compliant), set::mass(1.2), set::wall_upper(infinity),
      set::start(0, -0.3), set::restitution(restitution), set::contact_law(law),
      set::contact_exponent(law == ContactLaw::kelvin_voigt ? 1.0 : 1.5), set::seconds(0.2));
}

/// On an elastic linear spring, where w = 100 rad/s.
Scene on_a_spring() {
  return with(thrown(ContactLaw::hertz, 0.5), set::contact_exponent(1.0), set::stiffness(1.2e4));
}

/// At rest on the surface of the lower wall.
Scene laid(ContactLaw law, double stiffness = 1e8) {
  return with(thrown(law, 0.5), set::start_velocity(0), set::stiffness(stiffness));
}

/// How deep a wall carries a force [N].
double carried_at(const Scene& scene, double force) {
  return std::pow(force / scene.stiffness, 1 / scene.contact_exponent);
}

/// What theory says that a scene's law returns from an impact of 0.3 m/s.
double theoretical_restitution(const Scene& scene) {
  if (scene.contact_law == ContactLaw::kelvin_voigt) return scene.restitution_lower;
  const double factor = dissipation(scene.contact_law, scene.restitution_lower);
  return returned_restitution(factor * 0.3 / scene.contact_speed.value_or(0.3));
}

TEST(CompliantModel, ReturnsTheRestitutionOfEveryLawWhateverStiffnessMassAndExponent) {
  // Of its own speed, or of one that makes impacts more plastic, or almost elastic.
  const std::vector<std::optional<double>> contact_speeds = {{}, 0.15, 3.0, 300.0};
  for (const ContactLaw law : all_laws) {
    for (const double c : {0.1, 0.3, 0.5, 0.7, 0.9}) {
      for (const double n : {1.0, 1.3, 1.5, 2.0}) {
        for (const auto& contact_speed : contact_speeds) {
          SCOPED_TRACE(testing::Message() << static_cast<int>(law) << " " << c << " " << n << " "
                                          << contact_speed.value_or(0));
          Scene scene = with(thrown(law, c), set::stiffness(n < 1.4 ? 3e6 : 1e9),
                             set::mass(n == 2.0 ? 0.02 : 1.2), set::contact_speed(contact_speed));
          if (law != ContactLaw::kelvin_voigt) scene.contact_exponent = n;
          const Pressed pressed = press(scene);
          ASSERT_EQ(pressed.hits.size(), 1U);
          expect_close(pressed.end.velocity, 0.3 * theoretical_restitution(scene), 1e-8);
          // The wall of Kelvin and Voigt never pulls: the velocity never falls.
          EXPECT_TRUE(law != ContactLaw::kelvin_voigt ||
                      std::ranges::is_sorted(pressed.samples, {}, &Sample::velocity));
        }
      }
    }
  }
}

TEST(CompliantModel, PenetratesAsDeepAsTheoryAndAppearsInBothWallsAlike) {
  for (const ContactLaw law : {ContactLaw::hertz, ContactLaw::hunt_crossley, ContactLaw::flores}) {
    for (const double c : {0.1, 0.6}) {
      const Scene scene = thrown(law, c);
      const Pressed lower = press(with(scene, set::restitution_upper(0.9)));
      double depth = 0;
      for (const Sample& s : lower.samples) depth = std::max(depth, -s.position);
      expect_close(depth, peak_penetration(1e8, 1.5, 1.2, 0.3, dissipation(law, c)), 1e-9);
      EXPECT_TRUE(lower.tops.empty());

      const Pressed upper = press(with(scene, set::walls(-infinity, 0), set::start_velocity(0.3),
                                       set::restitution_lower(0.9)));
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
    const Scene scene = with(thrown(ContactLaw::hertz, 0.5), set::contact_exponent(n));
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

TEST(CompliantModel, FollowsALinearSpringUnderAPullThatTurnsToTheEndOfItsWindow) {
  // x'' = -w^2 x - P cos(W t) while x < 0: x = c (cos(W t) - cos(w t)) + v0/w sin(w t), where
  // c = -P / (w^2 - W^2).
  for (const auto& [turning, pull, leaves] : {std::tuple(1.0, 0.0, 0.0314),
                                              {4.0, 3.0, 0.027},
                                              {40.0, 3.0, 0.027},
                                              {3000.0, 3000.0, 0.027}}) {
    const double c = -pull / (1e4 - turning * turning);
    for (double end = 1e-4; end < leaves; end += 1e-4) {
      Pressed pressed = press(with(on_a_spring(), set::pull(1.2 * pull), set::pull_rotates(true),
                                   set::omega(turning), set::seconds(end)));
      EXPECT_EQ(pressed.end.time, end);
      pressed.samples.push_back({end, pressed.end.position, pressed.end.velocity});
      for (const auto& [t, position, velocity] : pressed.samples) {
        const double x =
            c * (std::cos(turning * t) - std::cos(100 * t)) - 0.003 * std::sin(100 * t);
        const double v = c * (100 * std::sin(100 * t) - turning * std::sin(turning * t)) -
                         0.3 * std::cos(100 * t);
        EXPECT_NEAR(position, x, 3e-9 * 3e-3) << t;
        EXPECT_NEAR(velocity, v, 3e-9 * 0.3) << t;
      }
    }
  }
}

TEST(CompliantModel, ErrsByNoMoreThanItsToleranceForFewEvaluationsAndRepeatsItself) {
  for (const double n : {1.0, 1.3, 1.5}) {
    const Scene scene = with(thrown(ContactLaw::exact_restitution, 0.3), set::contact_exponent(n));
    std::vector<double> errors;
    for (const auto& [tolerance, most] :
         {std::pair(1e-4, 400), {1e-6, 400}, {1e-8, 800}, {1e-10, 800}, {1e-12, 1200}}) {
      const Pressed pressed = press(scene, tolerance);
      errors.push_back(std::abs(pressed.end.velocity / 0.09 - 1));
      EXPECT_LT(errors.back(), 3 * tolerance) << n;
      EXPECT_GT(errors.back(), 1e-4 * tolerance) << "a tolerance that is not used";
      EXPECT_LT(pressed.end.evaluations, most) << n << " " << tolerance;
    }
    EXPECT_NEAR(std::log10(errors.front() / errors.back()) / 8, 1, 0.2)
        << "first order in the tolerance";
    EXPECT_EQ(press(scene).end.velocity, press(scene).end.velocity);
  }
}

/// A ball dropped on a compliant floor, with the stiffness it takes for some depth.
Scene ball_on_soft_floor(double stiffness) {
  return with(thrown(ContactLaw::exact_restitution, 0.8), set::stiffness(stiffness),
              set::start(0.5, 0), set::pull(9.8), set::mass(1), set::seconds(2));
}

TEST(CompliantModel, TendsToTheImpactModelAsTheContactTimeDoes) {
  // Contact times, and the weight's share of the rebound, fall with K^(-1/(n+1)).
  const Scene under_a_profile =
      with(thrown(ContactLaw::exact_restitution, 0.4), set::wall_upper(1e-3), set::start(0.5e-3, 0),
           set::friction(0.1), set::normal_force(1.0), set::pull(0.5),
           set::centrifugal_mass_radius(0.1), set::slider_mass_radius(0.02), set::seconds(1.5),
           set::profile(std::vector<SpeedKnot<double>>{{0.0, 2.0}, {0.7, 8.0}, {1.0, 5.0}}));
  for (const auto& [scene, hardest] :
       {std::pair(ball_on_soft_floor(1), 1e12), {under_a_profile, 1e20}}) {
    const auto time_of = [](const Scene& any) { return watch(any).hits.at(4).time; };
    const double hard = time_of(with(scene, set::fidelity(Fidelity::impact)));
    const auto error = [&, &scene = scene](double stiffness) {
      return std::abs(time_of(with(scene, set::stiffness(stiffness))) - hard);
    };
    for (const double softer : {1e-2, 1e-4, 1e-6}) {
      const double ratio = error(hardest * softer) / error(100 * hardest * softer);
      EXPECT_NEAR(std::log10(ratio) / 2, 0.4, 0.02);
    }
    EXPECT_LT(error(hardest), 1e-4);
  }
}

TEST(CompliantModel, ABouncingBallEndsAtTheDepthThatCarriesItWithoutTinySteps) {
  for (const double c : {0.1, 0.5, 0.9}) {
    const Scene scene = with(ball_on_soft_floor(1e10), set::restitution_lower(c));
    const Pressed minute = press(with(scene, set::seconds(60)));
    expect_close(minute.end.position, -carried_at(scene, 9.8), 1e-8);
    EXPECT_NEAR(minute.end.velocity, 0, 1e-9);
    EXPECT_EQ(minute.end.time, 60.0);
    EXPECT_LE(press(with(scene, set::seconds(6e4))).samples.size(), minute.samples.size() + 30);
  }
}

TEST(CompliantModel, RestsInTheWallItIsPressedAgainstFromTheStart) {
  for (const ContactLaw law : all_laws) {
    for (const double mu : {0.0, 0.2}) {
      for (int i = 1; i <= 20; ++i) {
        const Scene scene =
            with(laid(law), set::pull(0.37 * i), set::friction(mu), set::normal_force(1));
        const Pressed pressed = press(scene);
        EXPECT_TRUE(pressed.hits.empty());
        EXPECT_TRUE(pressed.samples.empty()) << "it takes no steps";
        expect_close(pressed.end.position, -carried_at(scene, scene.pull - mu));
      }
    }
  }
}

TEST(CompliantModel, SinksIntoAWallWhenAGrowingForceOvercomesFriction) {
  for (const double mu : {0.0, 0.25}) {
    // The force is 2 sin(3 t), inward.
    const Scene scene = with(laid(ContactLaw::exact_restitution, 1e10), set::pull(2),
                             set::pull_rotates(true), set::phase(-pi / 2), set::omega(3),
                             set::friction(mu), set::normal_force(4), set::seconds(0.4));
    const Pressed pressed = press(scene);
    ASSERT_FALSE(pressed.samples.empty());
    EXPECT_NEAR(pressed.samples.front().time, std::asin(mu * 4.0 / 2.0) / 3.0, 1e-3);
    // Slowly enough to carry the force at every depth.
    const double force = 2.0 * std::sin(1.2) - mu * 4.0;
    expect_close(pressed.end.position, -carried_at(scene, force), 1e-2);
    EXPECT_LT(pressed.samples.size(), 2000U);
  }
}

TEST(CompliantModel, HopsTooSlowToMatterEndWithoutCreeping) {
  // From 1e-21 m it arrives with 1.3e-10 m/s; the printed law, scaled with that speed, would let it
  // sink for hours. 1e-7 N would let it hop at picometres per second for hundreds of contacts.
  const Scene touching =
      with(thrown(ContactLaw::exact_restitution, 0.1), set::start(1e-21, 0), set::pull(10));
  const Scene hopping =
      with(thrown(ContactLaw::exact_restitution, 0.9), set::mass(1), set::stiffness(1e14),
           set::pull(1e-7), set::start(7e-12, 0), set::seconds(100));
  for (const auto& [scene, least, most] : {std::tuple(touching, 1U, 1U), {hopping, 2U, 4U}}) {
    const Pressed pressed = press(scene);
    EXPECT_GE(pressed.hits.size(), least);
    EXPECT_LE(pressed.hits.size(), most);
    expect_close(pressed.end.position, -carried_at(scene, scene.pull));
  }
}

TEST(CompliantModel, FrictionInAWallTakesItsTollOfEveryHalfTurnOfALinearSpring) {
  // About the depth P / w^2, every turning point is 2 f / w^2 nearer, until friction holds it.
  // f = 2.4, shift 4.8e-4 m.
  const Pressed pressed = press(
      with(on_a_spring(), set::restitution(1), set::mass(1), set::stiffness(1e4), set::pull(50),
           set::friction(0.3), set::normal_force(8), set::start_velocity(-0.15), set::seconds(3)));
  std::vector<double> turns;
  for (const Sample& s : pressed.samples) {
    if (s.velocity == 0) turns.push_back(-s.position);
  }
  EXPECT_GE(turns.size(), 6U);
  // The first turn follows from the energy: w^2 d^2 / 2 - (P - f) d = v^2 / 2.
  const double net = 50.0 - 2.4;
  double away = (net + std::sqrt(net * net + 1e4 * 0.15 * 0.15)) / 1e4 - 50.0 / 1e4;
  for (std::size_t k = 0; k < turns.size(); ++k) {
    expect_close(turns[k], 50.0 / 1e4 + away, 1e-9);
    EXPECT_EQ(std::abs(away) <= 2.4e-4, k + 1 == turns.size()) << "friction holds it";
    away = -away + (away > 0 ? 1 : -1) * 4.8e-4;
  }
  EXPECT_EQ(pressed.end.velocity, 0.0);
  EXPECT_EQ(-pressed.end.position, turns.back());
}

TEST(CompliantModel, HoldsABodyInTheWallUntilTheBalanceLeavesTheBandOfFriction) {
  // It rests where the wall carries pull - friction; it slips when the pull has fallen by twice
  // the friction.
  for (const double stiffness : {1e5, 1e8, 1e12}) {
    const Pressed pressed = press(with(laid(ContactLaw::exact_restitution, stiffness), set::pull(2),
                                       set::pull_rotates(true), set::omega(3), set::friction(0.25),
                                       set::normal_force(2), set::seconds(0.7)));
    ASSERT_GE(pressed.stretches.size(), 1U);
    expect_close(pressed.stretches[0].duration, std::acos((2.0 - 2 * 0.5) / 2.0) / 3.0, 1e-9);
    // And leaves the wall when the pull has turned against friction.
    const auto& flight = pressed.stretches.back();
    EXPECT_NEAR(flight.time, std::acos(-0.5 / 2.0) / 3.0, 3 * std::pow(stiffness, -1.0 / 3));
  }
}

TEST(CompliantModel, CountsAsTheImpactModelWhereWallsAreVeryStiff) {
  int compared = 0;
  for (const Case& a_case : all_cases()) {
    const auto& figure = a_case.claim.figure;
    const Scene scene = with(scene_of(a_case, exploratory_scene()), set::stiffness(1e18),
                             set::contact_law(ContactLaw::exact_restitution));
    for (const double omega : {figure ? figure->quiet : scene.omega, figure ? figure->loud : 9.0}) {
      SCOPED_TRACE(testing::Message() << a_case.id << " at " << omega);
      const Recording hard = record(with(scene, set::omega(omega)), 0.25, 0);
      if (!hard.certainty.certain || hard.certainty.margin.value_or(1.0) < 0.01) continue;
      const Pressed soft = press(with(scene, set::omega(omega)));
      EXPECT_EQ(std::ranges::count_if(
                    soft.hits, [&](const auto& hit) { return hit.speed > scene.counting_limit; }),
                hard.count);
      EXPECT_LT(soft.samples.size(), 6000U);
      ++compared;
    }
  }
  EXPECT_GE(compared, 18);
}

double depth_in_walls(const Scene& scene, double position) {
  return std::max(scene.wall_lower - position, position - scene.wall_upper);
}

double elastic_energy(const Scene& scene, double position) {
  const double exponent = scene.contact_exponent + 1;
  return scene.stiffness / exponent *
         std::pow(std::max(0.0, depth_in_walls(scene, position)), exponent);
}

TEST(CompliantModel, NeverGainsEnergyUnderASteadyPull) {
  for_random(21, 2000, [](RandomScenes& draws) {
    const Scene scene = with(compliant_scene(draws), set::omega(0), set::pull_rotates(false),
                             set::disturbance(0), set::seconds(0.5));
    ASSERT_NO_THROW(check(scene, "random"));
    double last = infinity;
    double level = 0;  // what the energy is the sum of, for its rounding and the steps' errors
    Pressed pressed = press(scene);
    pressed.samples.insert(pressed.samples.begin(),
                           {0, scene.start_position, scene.start_velocity});
    for (const auto& [time, position, velocity] : pressed.samples) {
      const double kinetic = 0.5 * scene.mass * velocity * velocity;
      const double potential = scene.pull * (position - scene.wall_lower);
      const double now = kinetic + potential + elastic_energy(scene, position);
      level = std::max({level, std::abs(now), kinetic, std::abs(potential)});
      ASSERT_LE(now, last + 3e-9 * level) << time;
      last = now;
    }
  });
}

TEST(CompliantModel, StaysWithinTheDepthThatItsEnergyAllowsInRandomScenes) {
  std::size_t contacts = 0;
  for_random(22, 2000, [&](RandomScenes& draws) {
    const Scene scene = compliant_scene(draws);
    const Pressed pressed = press(scene);
    const double square = scene.omega * scene.omega;
    const double force = std::abs(scene.pull) + std::abs(scene.disturbance) +
                         square * (scene.centrifugal_mass_radius + scene.slider_mass_radius);
    double fastest = std::abs(scene.start_velocity);
    for (const auto& hit : pressed.hits) fastest = std::max(fastest, hit.speed);
    for (const Sample& s : pressed.samples) {
      const double depth = depth_in_walls(scene, s.position);
      ASSERT_LE(elastic_energy(scene, s.position),
                0.5 * scene.mass * fastest * fastest + force * depth + 1e-12);
      ASSERT_GE(depth, -1e-15);
    }
    ASSERT_TRUE(std::ranges::is_sorted(pressed.samples, {}, &Sample::time));
    EXPECT_GE(pressed.end.time, 0.29);
    contacts += pressed.hits.size();
  });
  EXPECT_GT(contacts, 10'000U);
}

TEST(CompliantModel, RestsOnAWallWhereTheForcesBalanceFrictionButForRounding) {
  EXPECT_EQ(press(laid(ContactLaw::hunt_crossley)).end.position, 0.0) << "without forces";
  for (int i = 1; i < 30; ++i) {
    for (int k = 1; k < 30; ++k) {
      const Scene scene = with(laid(ContactLaw::hunt_crossley), set::omega(0), set::pull(0.1 * i),
                               set::disturbance(-0.1 * k), set::disturbance_frequency(0),
                               set::friction(0.1), set::normal_force(i + k));
      const Pressed pressed = press(scene);
      EXPECT_EQ(pressed.end.position, 0.0);
      EXPECT_EQ(pressed.stretches.size(), 1U);
      EXPECT_EQ(press(with(scene, set::start_position(0.5))).end.position, 0.5);
    }
  }
}

/// Classical Runge-Kutta steps in plain time through a contact with the lower wall that begins at
/// `time` and `speed`, without friction: a slow reference that shares only the law's formula. Its
/// error, by the edges of the contact, falls with the step's power n + 1. Returns the time and the
/// speed at which the body leaves.
std::array<double, 2> leave_wall(const Scene& scene, double time, double speed, double step) {
  using State = std::array<double, 2>;  // depth and speed
  const double damping =
      dissipation(scene.contact_law, scene.restitution_lower) / scene.contact_speed.value_or(speed);
  const auto motion = [&](const State& s, State& slope, double t) {
    const double contact = scene.stiffness * std::pow(std::max(0.0, s[0]), scene.contact_exponent) *
                           (1 + damping * s[1]);
    slope = {s[1], (-force_of_plate(scene, t) - contact) / scene.mass};
  };
  boost::numeric::odeint::runge_kutta4<State> stepper;
  for (State now = {0, speed};; time += step) {
    State next = now;
    stepper.do_step(motion, next, time, step);
    const double share = now[0] / (now[0] - next[0]);
    if (next[0] < 0) return {time + share * step, now[1] + share * (next[1] - now[1])};
    now = next;
  }
}

TEST(CompliantModel, PlainTimeStepsFindTheEndOfContactsUnderAllForces) {
  int compared = 0;
  for_random(23, 300, [&](RandomScenes& draws) {
    const Scene scene = with(compliant_scene(draws), set::friction(0), set::stiffness(3e6));
    if (scene.contact_law == ContactLaw::kelvin_voigt) return;
    const Pressed pressed = press(scene);
    if (pressed.hits.empty() || pressed.hits[0].wall != Wall::lower) return;
    const auto& hit = pressed.hits[0];
    const auto end = std::ranges::find_if(pressed.samples, [&](const Sample& s) {
      return s.time > hit.time && s.position == scene.wall_lower;
    });
    if (end == pressed.samples.end() || end->time > hit.time + 0.03) return;
    const double lasts = end->time - hit.time;
    const auto [time, speed] = leave_wall(scene, hit.time, hit.speed, lasts / 3000);
    EXPECT_NEAR((time - hit.time) / lasts, 1, 3e-5);
    EXPECT_NEAR(-speed / end->velocity, 1, 3e-5);
    ++compared;
  });
  EXPECT_GT(compared, 60);
}

}  // namespace
}  // namespace ricochet::carrier_track
