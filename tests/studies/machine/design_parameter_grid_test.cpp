#include <gtest/gtest.h>

#include "problems/carrier_track/counting/count.h"
#include "ricochet/machine.h"
#include "src/studies/machine/design_parameters.h"
#include "tests/carrier_track/suite/planar_second_case.h"
#include "tests/studies/machine/case_scene.h"

namespace ricochet::studies::advice {
namespace {

using namespace carrier_track;

/// Up to where every speed of a fine scan is quiet.
double fine_quiet(const Scene& scene, const Limit& limit, double from, double to) {
  double omega = from;
  while (omega <= to && measured(at_speed(scene, omega), limit.measure) <= limit.at_most) {
    omega *= 1.0005;
  }
  return omega;
}

TEST(QuietByScan, IsThatOfAFineScanWhereNothingNarrowLiesBelow) {
  const Limit limit{Measure::collisions, 7};
  for (const char* id : {"C1", "C3", "C5"}) {
    const Scene scene = case_scene(id);
    const auto quiet = quiet_by_scan(scene, limit, {1, 18});
    ASSERT_TRUE(quiet) << id;
    EXPECT_NEAR(*quiet, fine_quiet(scene, limit, 1, 18), 2e-3 * *quiet) << id;
  }
}

TEST(QuietByScan, SaysWhereEverySpeedIsOfOneKind) {
  const Scene scene = case_scene("C1");
  EXPECT_EQ(quiet_by_scan(scene, {Measure::collisions, 999}, {1, 18}), 18);
  EXPECT_FALSE(quiet_by_scan(scene, {Measure::collisions, 0}, {1, 18}));
}

TEST(QuietByScan, OfTheLongRunIsTheBorder) {
  const Limit limit{Measure::collisions_per_turn, 2};
  const double border = *quiet_up_to(case_scene("C1"), 2);
  EXPECT_NEAR(*quiet_by_scan(case_scene("C1"), limit, {1, 18, 1.02}), border, 1e-9);
  const double disturbed = *quiet_up_to(case_scene("C5"), 2);
  EXPECT_NEAR(*quiet_by_scan(case_scene("C5"), limit, {1, 18, 1.02}), disturbed, 2e-3 * disturbed);
}

TEST(DesignLines, HaveEachMachineChangedInOneDesignParameter) {
  const Scene scene = case_scene("C1");
  const QuietSpeed answer = quiet_speed(scene, {Limit{Measure::collisions, 7}, 1e-2, 18});
  const auto lines = design_lines(scene, answer);
  ASSERT_EQ(lines.size(), 4U);
  for (const auto& [parameter, values, quiet] : lines) {
    ASSERT_EQ(quiet.size(), DesignLine::points);
    EXPECT_NEAR(*quiet[10], *answer.fastest_quiet, 0.02);
    EXPECT_EQ(quiet[20], quiet_by_scan(parameter.turned(scene, parameter.most), *answer.limit,
                                       *coarse_scan(scene, answer)))
        << parameter.name;
  }
  EXPECT_NE(lines[1].quiet[20], lines[1].quiet[10]);
}

TEST(DesignLines, SayFirstWhatGivesMost) {
  const Scene scene = case_scene("C4");
  const QuietSpeed answer = quiet_speed(scene, {std::nullopt, 1e-2, 18});
  const auto lines = design_lines(scene, answer);
  report::Results results;
  add_design(lines, answer, coarse_scan(scene, answer), results);
  const Table& table = *results.table("design-parameters");
  ASSERT_EQ(table.rows.size(), 4U);
  const double own = number_in(*results.value("design-own")).value();
  double before = 1e9;
  each_row(table, [&](const Row& row) {
    const double best = row.number("best_quiet");
    EXPECT_LE(best, before);
    before = best;
    EXPECT_NEAR(row.number("best_change"), best / own - 1, 1e-12);
    EXPECT_GE(best, own);
    EXPECT_LE(row.number("worst_quiet"), own);
  });
  EXPECT_EQ(table[0].text("design_parameter"), "friction");
  // Twice the friction, as the longest of its line.
  Scene rougher = scene;
  rougher.friction *= 2;
  EXPECT_EQ(table[0].number("best"), rougher.friction);
  EXPECT_NEAR(table[0].number("best_quiet"), *quiet_up_to(rougher, 2), 1e-6);
  EXPECT_EQ(results.parts.at("design")[0].id, "friction");
}

TEST(DesignLines, AreMissingWhereNothingSaysWhatIsQuiet) {
  const Scene scene = planar_second_case();
  const QuietSpeed answer = quiet_speed(scene, {std::nullopt, 1e-2, 18});
  const auto lines = design_lines(scene, answer);
  EXPECT_TRUE(lines.empty());
  report::Results results;
  add_design(lines, answer, coarse_scan(scene, answer), results);
  EXPECT_TRUE(results.table("design-parameters")->rows.empty());
  EXPECT_TRUE(is_missing(*results.value("design")));
}

}  // namespace
}  // namespace ricochet::studies::advice
