#include "src/studies/machine/answer.h"

#include "ricochet/machine.h"
#include "src/studies/machine/regime_tables.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::studies::advice {
namespace {

using namespace carrier_track;
using report::Json;

/// On the lower wall of a clearance of 0.8 mm; its path has a radius of 65 mm.
const Scene resting =
    with(Scene{}, set::mass(1.2), set::centrifugal_mass_radius(1.2 * 0.065), set::walls(0, 0.8e-3),
         set::restitution(0.2), set::friction(0.2), set::normal_force(11.8), set::start(0, 0),
         set::revolutions(10), set::counting_limit(5e-3));

TEST(AnswerNotes, SayUpToWhatSpeedFrictionHolds) {
  // By hand: sqrt((friction normal_force + |pull| - |disturbance|) / |centrifugal_mass_radius -
  // slider_mass_radius|).
  EXPECT_THAT(notes_on(resting, {}),
              ElementsAre("Friction holds the carrier still up to 5.501 rad/s (52.53 rpm)."));
  const Scene driven =
      with(resting, set::slider_mass_radius(0.02), set::pull(0.5), set::disturbance(0.3));
  EXPECT_THAT(notes_on(driven, {}), Contains(HasSubstr("up to 6.644 rad/s (63.44 rpm).")));
  const Scene inward = with(driven, set::centrifugal(Centrifugal::inward), set::disturbance(0));
  EXPECT_THAT(notes_on(inward, {}), Contains(HasSubstr("hold the carrier still at every speed")));
  EXPECT_THAT(notes_on(with(inward, set::friction(0)), {}), IsEmpty());
  EXPECT_THAT(notes_on(with(resting, set::restitution_upper(0.7)), {}),
              Contains(HasSubstr("Restitution is 0.2 at the lower wall and 0.7 at the upper.")));
}

/// It strikes both walls, the lower one at 0.11 m/s, after which friction stops it.
const Scene launched = with(resting, set::revolutions(1.25), set::start_velocity(0.6));

TEST(AnswerNotes, WarnOfAWindowWhoseCollisionsAreTheStarts) {
  EXPECT_LE(start_share(resting, 6).of_start, 1);
  EXPECT_THAT(notes_on(resting, start_share(resting, 6)), Not(Contains(HasSubstr("window"))));
  EXPECT_THAT(
      notes_on(launched, start_share(launched, 4)),
      Contains(HasSubstr("The window of 1.25 turns is short: 2 of its 2 collisions at 4.000 rad/s "
                         "(38.20 rpm) are the start's, and do not come again.")));
  const Scene longer = with(launched, set::revolutions(100));  // where as many do not matter
  EXPECT_GE(start_share(longer, 7).of_start, 2);
  EXPECT_THAT(notes_on(longer, start_share(longer, 7)), Not(Contains(HasSubstr("window"))));
}

TEST(AnswerNotes, TakeTheSpeedAtWhichTheStartCausesMost) {
  EXPECT_FALSE(largest_start_share(resting, {}).has_value());
  const StartShare slow = start_share(launched, 2);
  const StartShare fast = start_share(launched, 7);
  ASSERT_NE(slow.of_start, fast.of_start);
  const double most = slow.of_start > fast.of_start ? 2 : 7;
  EXPECT_EQ(largest_start_share(launched, {7, 2}).value().omega, most);
  EXPECT_EQ(largest_start_share(launched, {2, 7}).value().omega, most);
}

TEST(PlanarModel, IsNeededWhereAPullAcrossBeatsFriction) {
  const Scene alone = case_scene("C1");
  EXPECT_THAT(planar_sentence(alone, 8), HasSubstr("No: the file has no clearance across"));
  // Off its track, in the middle of a clearance across.
  Scene scene = with(alone, set::contact_friction(false), [](Scene& of) {
    of.across = Across<double>{.wall_upper = 1e-3, .start_position = 5e-4};
  });
  EXPECT_THAT(planar_sentence(with(scene, set::slider_mass_radius(0)), 8),
              StartsWith("No: at 8.000 rad/s friction holds"));
  scene.across->pull = 10 * scene.friction * scene.normal_force;
  EXPECT_THAT(planar_sentence(scene, 8), StartsWith("Yes: at 8.000 rad/s"));
}

QuietSpeedAnswer answer_for(const Scene& scene, const QuietSpeedOptions& options) {
  return answer_quiet_speed("mine", scene, options, 0);
}

QuietSpeedOptions up_to(double collisions, double fastest) {
  return {Limit{Measure::collisions, collisions}, 1e-3, fastest};
}

/// tests/golden/threshold.txt has whole texts.
TEST(QuietSpeedAnswer, SaysWhatThereIsToSay) {
  const Scene c3 = case_scene("C3");
  EXPECT_THAT(text_of(answer_for(c3, up_to(99, 4))),
              HasSubstr("mine: every speed up to 4 rad/s is quiet"));
  const auto loud = answer_for(c3, up_to(0, 4));
  EXPECT_EQ(json_of(loud)["reason"], "loud at every speed");
  EXPECT_EQ(json_of(loud)["complete"], true);
  const auto rising = answer_for(planar_second_case(), {});
  EXPECT_THAT(text_of(rising), HasSubstr("mine: there is no threshold up to 18 rad/s"));
  EXPECT_TRUE(json_of(rising)["limit"].is_null());
}

TEST(QuietSpeedAnswer, IsTheSameInJson) {
  const auto answer = answer_for(case_scene("C1"), up_to(6, 10));
  EXPECT_THAT(text_of(answer),
              HasSubstr("The window of 1.38 turns is short: 2 of its 5 collisions at 8.0"));
  const Json json = json_of(answer);
  EXPECT_NEAR(json["fastest_quiet"], *answer.answer.fastest_quiet, 1e-8);
  EXPECT_EQ(json["limit"]["measure"], "collisions");
  EXPECT_EQ(json["levels"].size(), 3U);
  EXPECT_EQ(json["around"].size(), 3U);
  EXPECT_NEAR(json["release_speed"], 1.43, 0.02);
  EXPECT_GE(json["start_collisions"], 1);
  EXPECT_NEAR(json["percent_for_one"]["restitution"], -0.8, 0.1);
  EXPECT_TRUE(json["regimes"].empty());
  const Json long_run = json_of(answer_for(case_scene("C2"), {}));
  EXPECT_EQ(long_run["regimes"][0]["ends_by"], "release");
  EXPECT_TRUE(long_run["steps"].empty());
}

Regime regime(double from, double to, double least, double most) {
  Regime one{};
  one.from = from;
  one.to = to;
  one.least_per_turn = least;
  one.most_per_turn = most;
  one.moves = one.certain = true;
  return one;
}

TEST(RegimeTable, LeavesOutNarrowRegimesBetweenWiderOnes) {
  const auto ends_at = [](double to) { return testing::Field(&Regime::to, to); };
  EXPECT_THAT(without_narrow({regime(1, 1.005, 0, 0), regime(1.005, 2, 2, 2), regime(2, 2.01, 3, 3),
                              regime(2.01, 3, 4, 4), regime(3, 3.01, 5, 5)}),
              ElementsAre(ends_at(1.005), ends_at(2), ends_at(3), ends_at(3.01)));
}

TEST(RegimeTable, SaysWhereSilenceAndTheUsualLimitEnd) {
  EXPECT_EQ(counts_of(regime(1, 2, 4, 4)), "4");
  EXPECT_EQ(counts_of(regime(1, 2, 1, 4)), "1 to 4");
  EXPECT_EQ(
      summary_of({regime(0.01, 5.667, 0, 0), regime(5.667, 5.668, 1, 1), regime(5.668, 6.152, 2, 2),
                  regime(6.152, 6.153, 3, 3), regime(6.153, 18, 4, 4)}),
      "silent up to 5.667 rad/s (54.12 rpm), at most 2 collisions a turn up to 6.152 rad/s "
      "(58.75 rpm), more beyond");
  EXPECT_EQ(summary_of({regime(1, 2, 2, 2), regime(2, 3, 0, 0)}),
            "at most 2 collisions a turn up to 3.000 rad/s (28.65 rpm)");
  EXPECT_EQ(summary_of({regime(1, 2, 0, 0), regime(2, 3, 4, 4), regime(3, 4, 2, 2)}),
            "silent up to 2.000 rad/s (19.10 rpm), more beyond");
  EXPECT_EQ(summary_of({regime(1, 2, 3, 3)}), "more than 2 collisions a turn");
}

TEST(RegimeCurveTable, HasEveryBorderInItsTextAndEveryPointInItsData) {
  const RegimeMap map =
      regime_map(case_scene("C1"), {{"restitution", 0.05, 0.95}, 13, {"omega", 0.5, 12}});
  EXPECT_THAT(text_of(map, {}), testing::ContainsRegex("\n2 to 4 .* speeds +range\n"));
  const Json json = json_of(map);
  EXPECT_EQ(json["constant"], "restitution");
  EXPECT_EQ(json["own"], 0.1);
  EXPECT_EQ(json["followed"], true);
  ASSERT_EQ(json["curves"].size(), map.curves.size());
  std::size_t points = 0;
  for (std::size_t i = 0; i < map.curves.size(); ++i) {
    const Json& curve = json["curves"][i];
    EXPECT_EQ(curve["kind"], name_of(*map.curves[i].kind));
    EXPECT_EQ(curve["ends"], name_of(map.curves[i].ends));
    ASSERT_EQ(curve["points"].size(), map.curves[i].points.size());
    EXPECT_EQ(curve["points"][0]["slope"], *map.curves[i].points[0].slope);
    points += curve["points"].size();
  }
  ASSERT_EQ(json["columns"].size(), map.columns.size());
  EXPECT_EQ(json["columns"][3]["cells"][60], *map.columns[3].cells[60]);
  EXPECT_EQ(json["heights"].size(), map.columns[3].cells.size());
  EXPECT_EQ(point_table(map).rows.size(), points);
  // Of a disturbed machine it has the levels.
  const RegimeMap levels =
      regime_map(case_scene("C5"), {{"restitution", 0.1, 0.2}, 2, {"omega", 1, 4}});
  EXPECT_THAT(text_of(levels, {}),
              HasSubstr("The lowest speed [rad/s] at which the collisions change so, to 0.01"));
  EXPECT_EQ(json_of(levels)["curves"][0]["kind"], nullptr);
}

}  // namespace
}  // namespace ricochet::studies::advice
