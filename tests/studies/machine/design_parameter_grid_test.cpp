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
  EXPECT_FALSE(range.mixed);
  const QuietRange disturbed =
      quiet_range(case_scene("C5"), {Measure::collisions_per_turn, 2}, {1, 18});
  EXPECT_NEAR(*disturbed.quiet, *quiet_up_to(case_scene("C5"), 2), 1e-3 * *disturbed.quiet);
}

TEST(DesignParameterGrid, HasEveryCombinationInTheOrderOfItsDesignParameters) {
  const Scene scene = case_scene("C1");
  const QuietSpeed answer = quiet_speed(scene, {Limit{Measure::collisions, 7}, 1e-2, 18});
  const auto grid = design_parameter_grid(scene, answer);
  ASSERT_TRUE(grid);
  ASSERT_EQ(grid->design_parameters.size(), 4U);
  EXPECT_EQ(grid->combinations.size(), 5U * 5 * 3 * 3);
  EXPECT_NEAR(*grid->own.quiet, *answer.fastest_quiet, 0.02);
  // The second last level of friction, the last of the clearance, all else its own.
  Scene other = grid->design_parameters[1].turned(scene, grid->levels[1][3]);
  other = grid->design_parameters[2].turned(other, grid->levels[2][2]);
  const QuietRange expected = quiet_range(other, *answer.limit, grid->scan);
  const std::size_t place = ((2 * 5 + 3) * 3 + 2) * 3 + 0;
  EXPECT_EQ(grid->combinations[place].quiet, expected.quiet);
  EXPECT_EQ(grid->combinations[place].divide, expected.divide);
  EXPECT_NE(expected.quiet, grid->own.quiet);
}

TEST(DesignParameterGrid, SaysFirstWhatBuysMost) {
  const Scene scene = case_scene("C4");
  const auto grid = design_parameter_grid(scene, quiet_speed(scene, {std::nullopt, 1e-2, 18}));
  const report::Json data = json_of(grid);
  double before = 1e9;
  for (const report::Json& line : data["lines"]) {
    const double best = line["best"]["quiet"];
    EXPECT_LE(best, before);
    before = best;
    EXPECT_EQ(line["matters"].get<bool>(), best > data["own"]["quiet"].get<double>());
    EXPECT_NEAR(line["best"]["change"].get<double>(), best / data["own"]["quiet"].get<double>() - 1,
                1e-4);
  }
  EXPECT_EQ(data["lines"][0]["design_parameter"], "friction");
}

TEST(DesignParameterGrid, IsMissingWhereNothingSaysWhatIsQuiet) {
  const Scene scene = planar_second_case();
  EXPECT_TRUE(json_of(design_parameter_grid(scene, quiet_speed(scene, {std::nullopt, 1e-2, 18})))
                  .is_null());
}

}  // namespace
}  // namespace ricochet::studies::advice
