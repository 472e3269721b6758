#include <gtest/gtest.h>

#include <algorithm>

#include "problems/carrier_track/scene/contact_law.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "src/studies/paper/interpretation.h"

namespace ricochet::carrier_track {
namespace {

bool has(const std::vector<Unknown>& open, Unknown constant) {
  return std::find(open.begin(), open.end(), constant) != open.end();
}

Scene scene_with(const Interpretation& interpretation, const char* id = "C11") {
  return scene_of(find_case(id), interpretation, natural_constants());
}

TEST(UnknownParameters, AreAsManyAsTheirNames) {
  ASSERT_EQ(unknown_parameters().size(), unknown_size);
  EXPECT_EQ(unknown_parameters()[static_cast<std::size_t>(Unknown::clearance)].name, "clearance");
  EXPECT_EQ(unknown_parameters()[static_cast<std::size_t>(Unknown::counting_limit)].name,
            "counting_limit");
  EXPECT_EQ(unknown_parameters()[static_cast<std::size_t>(Unknown::contact_speed)].name,
            "contact_speed");
}

TEST(UnknownParameters, HaveNaturalValuesWithinTheirBounds) {
  const Constants natural = natural_constants();
  for (std::size_t i = 0; i < unknown_size; ++i) {
    const UnknownParameter& c = unknown_parameters()[i];
    EXPECT_LT(c.lower, c.upper) << c.name;
    EXPECT_GE(natural[i], c.lower) << c.name;
    EXPECT_LE(natural[i], c.upper) << c.name;
    EXPECT_TRUE(!c.logarithmic || c.lower > 0) << c.name;
  }
}

TEST(UnknownParameters, HaveAPlaceWithinTheirBounds) {
  const UnknownParameter size = {"size", "m", 1e-3, 10, true, {}, ""};
  EXPECT_DOUBLE_EQ(value_at(size, 0.25), 1e-2);
  EXPECT_DOUBLE_EQ(share_of(size, 1), 0.75);
  EXPECT_EQ(share_of(size, 100), 1);
  const UnknownParameter place = {"place", "m", -1, 3, false, {}, ""};
  EXPECT_DOUBLE_EQ(value_at(place, 0.25), 0);
  EXPECT_DOUBLE_EQ(share_of(place, 2), 0.75);
  EXPECT_EQ(share_of(place, -2), 0);
}

TEST(UnknownParameters, AreThoseThatTheInterpretationUses) {
  Interpretation r;
  EXPECT_EQ(unknowns_of(r).size(), 9U);
  EXPECT_TRUE(has(unknowns_of(r), Unknown::revolutions));
  EXPECT_FALSE(has(unknowns_of(r), Unknown::seconds));
  r.window = WindowUnit::seconds;
  EXPECT_TRUE(has(unknowns_of(r), Unknown::seconds));
  r.normal_force = NormalForce::weight;
  EXPECT_FALSE(has(unknowns_of(r), Unknown::normal_force));
  r.rule = Rule::peaks_1mm;
  EXPECT_FALSE(has(unknowns_of(r), Unknown::counting_limit));
  r = {};
  r.counted = Counted::later;
  EXPECT_TRUE(has(unknowns_of(r), Unknown::first_turn));
  r.counted = Counted::long_run;
  EXPECT_EQ(unknowns_of(r).size(), 6U);  // not where and how fast it starts, and when
  EXPECT_FALSE(has(unknowns_of(r), Unknown::start_velocity));
}

TEST(UnknownParameters, MakeValidScenesOfEveryInterpretationAndCase) {
  for (const Interpretation& core : core_interpretations()) {
    for (const Interpretation& r : variations(core)) {
      for (const Case& c : all_cases()) {
        const Scene scene = scene_of(c, r, natural_constants());
        EXPECT_NO_THROW(check(scene_at(scene, r, natural_constants(), 3.0), name_of(r)));
      }
    }
  }
}

TEST(UnknownParameters, PutEveryAnswerIntoTheScene) {
  Interpretation r;
  EXPECT_EQ(scene_with(r).mass, 1.2);
  EXPECT_EQ(scene_with(r).restitution_lower, 0.9);
  EXPECT_EQ(scene_with(r).friction, 0.4);
  EXPECT_EQ(scene_with(r).disturbance, 1.0);
  EXPECT_DOUBLE_EQ(scene_with(r).start_position, 1e-3);

  r.base = Base::spindle;
  r.disturbance = DisturbanceKind::acceleration;
  EXPECT_EQ(scene_with(r).mass, 1.8);
  EXPECT_EQ(scene_with(r).disturbance, 1.8);

  r = {};
  r.normal_force = NormalForce::weight;
  EXPECT_DOUBLE_EQ(scene_with(r).normal_force, 1.2 * 9.81);
  r.normal_force = NormalForce::contact;
  EXPECT_TRUE(scene_with(r).contact_friction);

  r = {};
  r.recovery = Recovery::hunt_crossley;
  EXPECT_DOUBLE_EQ(scene_with(r, "C1").restitution_lower,
                   returned_restitution(dissipation(ContactLaw::hunt_crossley, 0.1)));
  r.recovery = Recovery::contact_speed;
  EXPECT_EQ(scene_with(r).fidelity, Fidelity::compliant);
  EXPECT_EQ(scene_with(r).contact_speed, 0.1);

  r = {};
  r.rule = Rule::peaks_100um;
  EXPECT_EQ(scene_with(r).rule, CountRule::peaks);
  EXPECT_EQ(scene_with(r).peak_low, 1e-4);
  EXPECT_EQ(scene_with(r).peak_high, 3e-3);
}

TEST(UnknownParameters, TurnASpeedIntoAProfileWhereThereAreCrossings) {
  Interpretation r;
  r.transition = Transition::crossing;
  const Constants constants = natural_constants();
  const Scene scene = scene_at(scene_with(r), r, constants, 5.0);
  ASSERT_FALSE(scene.profile.empty());
  double fastest = 0;
  for (const auto& knot : scene.profile) fastest = std::max(fastest, knot.omega);
  EXPECT_NEAR(fastest, 5.0 / std::pow(std::cos(0.4), 2), 1e-12);
  EXPECT_TRUE(scene_at(scene, Interpretation{}, constants, 4.0).profile.empty());
}

}  // namespace
}  // namespace ricochet::carrier_track
