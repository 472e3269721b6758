#include "tests/carrier_track/models/watch.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

/// What a kilogram, a metre and a second are in other units. Powers of two change no digit.
struct Units {
  double kilogram, metre, second;
};

Scene written_in(const Units& units, Scene scene) {
  const double m = units.metre;
  const double speed = m / units.second;
  const double frequency = 1 / units.second;
  const double newton = units.kilogram * speed / units.second;
  scene.mass *= units.kilogram;
  for (double* length : {&scene.wall_lower, &scene.wall_upper, &scene.start_position,
                         &scene.peak_high, &scene.peak_low}) {
    *length *= m;
  }
  for (double* force : {&scene.normal_force, &scene.pull, &scene.disturbance}) *force *= newton;
  scene.centrifugal_mass_radius *= units.kilogram * m;
  scene.slider_mass_radius *= units.kilogram * m;
  scene.start_velocity *= speed;
  scene.counting_limit *= speed;
  if (scene.contact_speed) *scene.contact_speed *= speed;
  scene.omega *= frequency;
  scene.disturbance_frequency *= frequency;
  scene.stiffness *= newton / std::pow(m, scene.contact_exponent);
  for (auto& knot : scene.profile) knot.time *= units.second, knot.omega *= frequency;
  if (auto* seconds = std::get_if<Seconds>(&scene.window)) seconds->count *= units.second;
  if (scene.across) {
    scene.across->pull *= newton;
    for (double* length :
         {&scene.across->wall_lower, &scene.across->wall_upper, &scene.across->start_position}) {
      *length *= m;
    }
    scene.across->start_velocity *= speed;
  }
  return scene;
}

/// A tolerance of a length, a time or a speed that is a plain number would show.
constexpr Units others[] = {{1, 1, 0x1p-16}, {1, 1, 0x1p8}, {0x1p-5, 0x1p-8, 0x1p-3}};

template <class Draw>
void expect_the_same_in_other_units(std::uint64_t seed, int scenes, const Draw& draw,
                                    double error = 0) {
  const auto same = [error](double again, double told) { ASSERT_NEAR(again, told, error); };
  std::size_t impacts = 0;
  for_random(seed, scenes, [&](RandomScenes& draws) {
    // So low that the resting speed is a share of it; of others it is a plain number, 1e-9.
    const Scene scene = with(draw(draws), set::counting_limit(1e-12));
    const auto told = watch(scene);
    impacts += told.hits.size();
    for (const Units& units : others) {
      const double speed = units.metre / units.second;
      const auto again = watch(written_in(units, scene));
      ASSERT_EQ(again.hits.size(), told.hits.size()) << units.second;
      for (std::size_t i = 0; i < told.hits.size(); ++i) {
        ASSERT_EQ(again.hits[i].wall, told.hits[i].wall);
        same(again.hits[i].time / units.second, told.hits[i].time);
        same(again.hits[i].speed / speed, told.hits[i].speed);
      }
      same(again.end.time / units.second, told.end.time);
      same(again.end.position / units.metre, told.end.position);
      same(again.end.velocity / speed, told.end.velocity);
    }
  });
  EXPECT_GT(impacts, 100U);
}

TEST(Units, OfMassLengthAndTimeChangeNoBitOfTheImpactModel) {
  expect_the_same_in_other_units(31, 300, [](RandomScenes& draws) { return draws.next(); });
}

TEST(Units, OfMassLengthAndTimeChangeNoBitOfThePlanarModel) {
  expect_the_same_in_other_units(32, 100, [](RandomScenes& draws) { return draws.next_planar(); });
}

/// But for rounding: a power has other last bits in other units. Among walls that are no linear
/// springs, tens of impacts enlarge them.
TEST(Units, OfMassLengthAndTimeChangeNothingOfTheCompliantModel) {
  const auto draw = [](RandomScenes& draws) {
    return with(compliant_scene(draws), set::contact_exponent(1.0));
  };
  expect_the_same_in_other_units(33, 500, draw, 1e-9);
}

}  // namespace
}  // namespace ricochet::carrier_track
