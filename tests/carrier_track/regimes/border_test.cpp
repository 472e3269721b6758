#include "problems/carrier_track/regimes/border.h"

#include "problems/carrier_track/regimes/border_curve.h"
#include "problems/carrier_track/regimes/followed_motion.h"
#include "problems/carrier_track/regimes/steady_motion.h"
#include "ricochet/error.h"
#include "tests/carrier_track/regimes/machines.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

TEST(SteadyMotion, OfABallOnAShakenTableIsTheClosedFormOrbit) {
  using namespace shaken_table;
  for (const double e : {0.2, 0.5, 0.8}) {
    const double strength = (fold_strength(e) + flip_strength(e)) / 2;
    Scene scene = on_orbit(e, strength);
    scene.start_velocity *= 1.02;  // settles on it
    const SteadyMotion motion = steady_motion(scene);
    ASSERT_TRUE(motion.settled);
    EXPECT_EQ(motion.turns, 1);
    EXPECT_EQ(motion.rest, Rest::never);
    ASSERT_EQ(motion.impacts.size(), 1U);
    const double speed = shaken_table::gravity * 2 * std::numbers::pi / scene.omega / (1 + e);
    EXPECT_NEAR(motion.impacts[0].speed / speed, 1, 1e-12);
    EXPECT_NEAR(motion.energy_per_turn(), (1 - e * e) * speed * speed, 1e-10 * speed * speed);
    EXPECT_NEAR(motion.determinant, e * e, 1e-10);
    EXPECT_TRUE(motion.stable());
  }
}

TEST(SteadyMotion, AgreesWithLongSimulations) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    const Scene machine = random_machine(seed);
    const double omega = MachineDraw(seed + 1000).even_logarithm(0.5, 18);
    const SteadyMotion motion = steady_motion(at_speed(machine, omega));
    if (!motion.settled) continue;
    const int observed = motion.turns * (60 / motion.turns);
    EXPECT_DOUBLE_EQ(motion.collisions_per_turn(),
                     collisions_in_the_long_run(motion.orbit, omega, 260, observed))
        << seed << " at " << omega;
    ++compared;
  }
  EXPECT_GT(compared, 120);
}

TEST(SteadyMotion, IsStillBelowTheRelease) {
  const SteadyMotion still = steady_motion(at_speed(default_machine(), 1.0));
  EXPECT_TRUE(still.settled);
  EXPECT_EQ(still.rest, Rest::always);
  EXPECT_EQ(still.share_at_rest, 1);
  EXPECT_EQ(still.fastest_impact(), 0);
  // Just above it a small pull moves the carrier by some 1e-8 m a turn, until it is at a wall.
  const SteadyMotion gliding =
      steady_motion(with(default_machine(), set::omega(1.4176), set::start_velocity(0)));
  ASSERT_TRUE(gliding.settled);
  EXPECT_EQ(gliding.orbit.start_position, default_machine().wall_lower);
  EXPECT_EQ(gliding.rest, Rest::always);
}

TEST(SteadyMotion, StaysOnAnOrbitThatIsFollowed) {
  const double e = 0.5;
  const SteadyMotion stable = steady_motion(shaken_table::on_orbit(e, 1.5));
  // Beyond the flip the orbit is unstable, and still there.
  const double beyond = shaken_table::speed_at(1.03 * shaken_table::flip_strength(e));
  const SteadyMotion unstable = followed(stable, beyond);
  EXPECT_EQ(unstable.turns, 1);
  EXPECT_FALSE(unstable.stable());
  EXPECT_NEAR(unstable.impacts.at(0).speed,
              shaken_table::gravity * 2 * std::numbers::pi / beyond / (1 + e), 1e-12);
}

TEST(SteadyMotion, RepeatsWithTheDisturbanceWhereThatRepeats) {
  const auto shaken = [](double omega) {
    return with(default_machine(), set::disturbance(0.1), set::disturbance_frequency(1),
                set::omega(omega));
  };
  EXPECT_EQ(forcing_turns(shaken(3)), 3);
  EXPECT_EQ(forcing_turns(shaken(2.5)), 5);
  EXPECT_EQ(forcing_turns(shaken(2.5123)), 0);
  const SteadyMotion motion = steady_motion(shaken(3));
  EXPECT_EQ(std::tuple(motion.settled, motion.turns, motion.collisions), std::tuple(true, 3, 6));
}

/// An elastic carrier: its impacts in a turn would not fit into memory.
TEST(SteadyMotion, OfVeryManyImpactsIsAveragedOverAPartOfATurn) {
  const SteadyMotion motion = steady_motion(
      with(Scene{}, set::wall_upper(1e-7), set::start(0, 1), set::counting_limit(1e-3)));
  EXPECT_FALSE(motion.settled);
  EXPECT_NEAR(motion.collisions_per_turn() / (2 * std::numbers::pi * 1e7), 1, 1e-4);
  EXPECT_NEAR(motion.fastest_impact(), 1, 1e-12);
}

/// A margin along a step: a cubic of t in [0, 1].
struct Cubic {
  double c0, c1, c2, c3;

  double value(double t) const { return c0 + t * (c1 + t * (c2 + t * c3)); }
  double slope(double t) const { return c1 + t * (2 * c2 + t * 3 * c3); }
  bool passes_zero() const {
    for (int k = 0; k <= 1000; ++k) {
      if ((value(k / 1000.0) > 0) != (value(0) > 0)) return true;
    }
    return false;
  }
  bool is_said_to_keep_its_sign(double step) const {
    return keeps_sign({value(0), slope(0) / step}, {value(1), slope(1) / step}, step);
  }
};

TEST(KeptSign, IsNeverSaidOfACubicThatPassesZero) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  int kept = 0, passes = 0;
  for (int k = 0; k < 20'000; ++k) {
    const Cubic cubic{number(random), number(random), number(random), number(random)};
    const bool said = cubic.is_said_to_keep_its_sign(std::exp(3 * number(random)));
    if (cubic.passes_zero()) {
      ++passes;
      EXPECT_FALSE(said) << cubic.c0 << " " << cubic.c1 << " " << cubic.c2 << " " << cubic.c3;
    } else if (said) {
      ++kept;
    }
  }
  EXPECT_GT(passes, 5'000);
  EXPECT_GT(kept, 2'000);
  // Where the margin hardly changes it is said.
  for (const double c0 : {-1.0, 1.0}) {
    EXPECT_TRUE((Cubic{c0, 0.1, 0.05, -0.02}).is_said_to_keep_its_sign(0.01));
  }
}

/// The first border of the shaken table's orbit from one strength to another.
Border border_of_table(double e, double from, double to) {
  const SteadyMotion near = steady_motion(shaken_table::on_orbit(e, from));
  return first_border(near, followed(near, shaken_table::speed_at(to)));
}

TEST(Border, FoldAndFlipOfTheShakenTableHaveTheirClosedForms) {
  using namespace shaken_table;
  const auto fold_at = [](double e) { return speed_at(fold_strength(e)); };
  const auto flip_at = [](double e) { return speed_at(flip_strength(e)); };
  for (const double e : {0.2, 0.5, 0.8}) {
    SCOPED_TRACE(e);
    const double flip = flip_strength(e), fold = fold_strength(e);
    const Border doubling = border_of_table(e, 0.98 * flip, 1.02 * flip);
    EXPECT_EQ(doubling.kind, RegimeEnd::flip);
    EXPECT_NEAR(doubling.omega / flip_at(e), 1, 1e-10);
    const Border vanishing = border_of_table(e, 1.05 * fold, 0.98 * fold);
    EXPECT_EQ(vanishing.kind, RegimeEnd::fold);
    EXPECT_NEAR(vanishing.omega / fold_at(e), 1, 1e-10);
    // And so have those that are followed to another restitution.
    BorderCurve flips(doubling, "restitution"), folds(vanishing, "restitution");
    for (const double other : {e, e + 0.05, e - 0.05}) {
      ASSERT_TRUE(flips.follow_to(other));
      EXPECT_NEAR(flips.here().omega / flip_at(other), 1, 1e-9);
      const double slope = (flip_at(other + 1e-6) - flip_at(other - 1e-6)) / 2e-6;
      EXPECT_NEAR(flips.here().slope / slope, 1, 1e-5);
    }
    for (const double other : {e, e + 0.05}) {
      ASSERT_TRUE(folds.follow_to(other)) << static_cast<int>(folds.end());
      EXPECT_NEAR(folds.here().omega / fold_at(other), 1, 1e-7);
    }
  }
}

TEST(Border, ReleaseIsWhereTheForceEqualsFrictionAndPull) {
  const Scene machine = with(default_machine(), set::start(default_machine().wall_lower, 0),
                             set::slider_mass_radius(0));
  const SteadyMotion still = steady_motion(at_speed(machine, 1.0));
  const Border border = first_border(still, followed(still, 2.0));
  EXPECT_EQ(border.kind, RegimeEnd::release);
  BorderCurve curve(border, "friction");
  for (const double friction : {machine.friction, 0.05, 0.4}) {
    ASSERT_TRUE(curve.follow_to(friction));
    const double omega = std::sqrt((friction * machine.normal_force + machine.pull) /
                                   machine.centrifugal_mass_radius);
    EXPECT_NEAR(curve.here().omega / omega, 1, 1e-12);
    const double slope = machine.normal_force / (2 * omega * machine.centrifugal_mass_radius);
    EXPECT_NEAR(curve.here().slope / slope, 1, 1e-12);
  }
}

TEST(Border, AnImpactHasTheCountingLimitThere) {
  const SteadyMotion slow = steady_motion(at_speed(default_machine(), 7.0));
  const auto border = first_border(slow, followed(slow, 9.0));
  EXPECT_EQ(border.kind, RegimeEnd::counting_limit);
  EXPECT_EQ(std::pair(border.before.collisions, border.after.collisions), std::pair(2, 3));
  // The third fastest impact of a turn.
  EXPECT_THAT(rank_margin(border.before, 3), AllOf(testing::Le(0), testing::Ge(-1e-10)));
  EXPECT_GT(rank_margin(border.after, 3), 0);
}

/// The border of a machine like the default one beyond which a turn has more than two collisions.
Border louder_than_two(const Scene& machine) {
  const SteadyMotion slow = steady_motion(at_speed(machine, 4.0));
  return first_border(slow, followed(slow, 16.0));
}

Scene scaled_by(const std::string& key, double factor) {
  Scene machine = with(default_machine(), set::pull(0.02));
  set_constant(machine, key, factor * constant_named(machine, key));
  return machine;
}

TEST(BorderCurve, HasTheBordersSolvedAnewAndTheirSlopes) {
  for (const std::string key : {"mass", "clearance", "restitution", "friction", "normal_force",
                                "centrifugal_mass_radius", "counting_limit", "pull"}) {
    SCOPED_TRACE(key);
    const auto border_at = [&](double factor) { return louder_than_two(scaled_by(key, factor)); };
    BorderCurve curve(border_at(1), key);
    const double constant = constant_named(scaled_by(key, 1), key);
    EXPECT_DOUBLE_EQ(curve.here().constant, constant);
    const double change = (border_at(1 + 1e-5).omega - border_at(1 - 1e-5).omega) / 2e-5;
    EXPECT_NEAR(curve.here().slope * constant, change, 1e-6 * std::abs(change) + 1e-7);
    for (const double factor : {0.8, 1.25}) {
      ASSERT_TRUE(curve.follow_to(factor * constant));
      EXPECT_NEAR(curve.here().omega / border_at(factor).omega, 1, 1e-10);
    }
  }
}

TEST(BorderCurve, EndsWhereTheBorderEnds) {
  BorderCurve curve(louder_than_two(default_machine()), "counting_limit");
  EXPECT_FALSE(curve.follow_to(-1));
  EXPECT_GT(curve.here().constant, 0);
  EXPECT_NE(curve.end(), CurveEnd::range);
}

TEST(BorderCurve, SaysThatItTurnsBack) {
  const Scene machine = random_machine(10);
  const std::vector<Regime> regimes = regimes_of(machine, {0.01, 6});
  BorderCurve curve(border_between(regimes.at(3), regimes.at(4)), "counting_limit");
  ASSERT_FALSE(curve.follow_to(0.3 * curve.here().constant));
  EXPECT_EQ(curve.end(), CurveEnd::fold_back);
  // The speed of the impact has its least value there: no machine with a lower limit has the
  // border.
  for (const double beside : {1e-4, -1e-4}) {
    const double limit = curve.here().constant * (1 + beside);
    std::set<double> counts;
    for (double factor = 0.99; factor < 1.01; factor += 5e-4) {
      const Scene there = at_speed(machine, factor * curve.here().omega);
      counts.insert(steady_motion(with(there, set::counting_limit(limit))).collisions);
    }
    EXPECT_EQ(counts.size() > 1, beside > 0);
  }
}

TEST(BorderCurve, BeginsBetweenTwoRegimes) {
  const std::vector<Regime> regimes = regimes_of(default_machine());
  ASSERT_GT(regimes.size(), 3U);
  for (std::size_t i = 0; i + 1 < regimes.size(); ++i) {
    const BorderCurve curve(border_between(regimes[i], regimes[i + 1]), "friction");
    EXPECT_NEAR(curve.here().omega / regimes[i].to, 1, 1e-11);
  }
}

TEST(BorderCurve, RefusesEqualMotionsAndUnknownConstants) {
  const SteadyMotion still = steady_motion(at_speed(default_machine(), 1.0));
  EXPECT_THROW(BorderCurve({1.0, RegimeEnd::release, still, still}, "friction"),
               std::invalid_argument);
  EXPECT_THROW(BorderCurve(louder_than_two(default_machine()), "wall_lower"), InputError);
}

}  // namespace
}  // namespace ricochet::carrier_track
