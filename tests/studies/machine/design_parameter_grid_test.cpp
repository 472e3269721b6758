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

TEST(QuietRange, IsThatOfAFineScanWhereNothingNarrowLiesBelow) {
  const Limit limit{Measure::collisions, 7};
  for (const char* id : {"C1", "C3", "C5"}) {
    const Scene scene = case_scene(id);
    const QuietRange range = quiet_range(scene, limit, {1, 18});
    ASSERT_TRUE(range.quiet) << id;
    EXPECT_NEAR(*range.quiet, fine_quiet(scene, limit, 1, 18), 2e-3 * *range.quiet) << id;
    ASSERT_TRUE(range.divide) << id;
    EXPECT_GE(*range.divide, *range.quiet) << id;
  }
}

TEST(QuietRange, SaysWhereEverySpeedIsOfOneKind) {
  const Scene scene = case_scene("C1");
  const QuietRange quiet = quiet_range(scene, {Measure::collisions, 999}, {1, 18});
  EXPECT_TRUE(quiet.to_the_end);
  EXPECT_EQ(quiet.quiet, 18);
  EXPECT_FALSE(quiet.divide);
  const QuietRange loud = quiet_range(scene, {Measure::collisions, 0}, {1, 18});
  EXPECT_FALSE(loud.quiet);
  EXPECT_FALSE(loud.to_the_end);
}

TEST(QuietRange, OfTheLongRunIsTheBorder) {
  const Scene scene = case_scene("C1");
  const QuietRange range = quiet_range(scene, {Measure::collisions_per_turn, 2}, {1, 18});
  EXPECT_NEAR(*range.quiet, *quiet_up_to(scene, 2), 1e-9);
  EXPECT_FALSE(range.divide) << "quiet and loud do not mix";
  const QuietRange disturbed =
      quiet_range(case_scene("C5"), {Measure::collisions_per_turn, 2}, {1, 18});
  EXPECT_NEAR(*disturbed.quiet, *quiet_up_to(case_scene("C5"), 2), 1e-3 * *disturbed.quiet);
}

TEST(DesignLines, HaveEachMachineChangedInOneDesignParameter) {
  const Scene scene = case_scene("C1");
  const QuietSpeed answer = quiet_speed(scene, {Limit{Measure::collisions, 7}, 1e-2, 18});
  const auto lines = design_lines(scene, answer);
  ASSERT_TRUE(lines);
  ASSERT_EQ(lines->design_parameters.size(), 4U);
  EXPECT_NEAR(*lines->own.quiet, *answer.fastest_quiet, 0.02);
  for (std::size_t k = 0; k < 4; ++k) {
    const DesignParameter& one = lines->design_parameters[k];
    ASSERT_EQ(lines->lines[k].size(), DesignLines::points_of_a_line);
    EXPECT_EQ(lines->lines[k][10].quiet, lines->own.quiet) << one.name;
    const QuietRange expected =
        quiet_range(one.turned(scene, one.most), *answer.limit, lines->scan);
    EXPECT_EQ(lines->lines[k][20].quiet, expected.quiet) << one.name;
    EXPECT_EQ(lines->lines[k][20].divide, expected.divide) << one.name;
  }
  EXPECT_NE(lines->lines[1][20].quiet, lines->own.quiet);
}

TEST(DesignLines, SayFirstWhatGivesMost) {
  const Scene scene = case_scene("C4");
  const auto lines = design_lines(scene, quiet_speed(scene, {std::nullopt, 1e-2, 18}));
  report::Results results;
  add_design(lines, results);
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
  const auto lines = design_lines(scene, quiet_speed(scene, {std::nullopt, 1e-2, 18}));
  EXPECT_FALSE(lines);
  report::Results results;
  add_design(lines, results);
  EXPECT_TRUE(results.table("design-parameters")->rows.empty());
  EXPECT_TRUE(is_missing(*results.value("design")));
}

}  // namespace
}  // namespace ricochet::studies::advice
