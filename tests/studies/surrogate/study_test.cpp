#include "src/studies/surrogate/study.h"

#include <tbb/global_control.h>

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/gradients/shape_derivatives.h"
#include "problems/carrier_track/suite/machine.h"
#include "tests/studies/pages.h"
#include "tests/support/problems.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::studies::surrogate {
namespace {

using namespace carrier_track;

TEST(SurrogateStudy, FillsItsPageAndDrawsItsCharts) {
  const report::Results results = report::results_in(surrogate_study().compute(true));
  const StudyPage page = study_page("surrogate", results);
  EXPECT_TRUE(page.files.contains("speed-gap.svg"));
  EXPECT_TRUE(page.files.contains("validity-trend.svg"));
  for (const char* section : {"## How large is the surrogate's bias?", "## Is the surrogate cont",
                              "## Where does the gradient mean", "## Are the derivatives right?"}) {
    EXPECT_THAT(page.files.at("summary.md"), HasSubstr(section));
  }
  for (const Table& table : results.tables)
    EXPECT_TRUE(table.name == "unexplained" || !table.rows.empty()) << table.name;
  EXPECT_THAT(page.terminal, HasSubstr("At smoothing parameter 0.25"));
}

TEST(Bias, KnowsTheBestOfTheCountAndClosesAsTheSmoothingGoesToZero) {
  const Table table = bias(0.25, {1.0, 1e-7});
  const auto machines = all_machines();
  ASSERT_EQ(table.rows.size(), 2 * machines.size());
  for (std::size_t c = 0; c < machines.size(); ++c) {
    const auto scan = scan_speeds(machines[c].scene, 0.25, 18);
    std::size_t last = scan.counts.size() - 1;
    while (scan.counts[last] > machines[c].quiet_limit) --last;
    EXPECT_EQ(table[2 * c].number("fastest"), scan.omega(last)) << machines[c].id;
    const Row closed = table[2 * c + 1];
    EXPECT_EQ(closed.number("speed_optimality_gap"), 0.0) << machines[c].id;
    EXPECT_EQ(closed.number("count_optimality_gap"), 0) << machines[c].id;
    EXPECT_TRUE(closed.is("quiet")) << machines[c].id;
  }
  EXPECT_LT(table[0].number("speed_optimality_gap"), -1) << "C1, where the surrogate is wide";
}

TEST(Bias, SaysHowFarTheFastestQuietSpeedIsOff) {
  Table table{"bias", columns_named("case,fastest,smoothing,speed,speed_optimality_gap,quiet,"
                                    "count_optimality_gap")};
  // Cases that are truly quiet up to 5 rad/s, at two smoothing parameters.
  for (const auto& [id, wide, narrow] :
       {std::tuple("A", 6.0, 5.0), {"B", 8.0, 5.02}, {"C", 4.5, 5.0}}) {
    table.add(id, 5, 0.25, wide, 5 - wide, wide <= 5, 0);
    table.add(id, 5, 0.001, narrow, 5 - narrow, narrow <= 5, 0);
  }
  report::Results results;
  add_bias(results, table, 0.01);
  // |5 - 6|, |5 - 8| and |5 - 4.5|: the median is 1, the largest 3, and two are too fast.
  EXPECT_THAT(text_of(*results.value("finding")),
              AllOf(HasSubstr("off by 1.00 rad/s in the median of 3 cases, by 3.00 at worst, "
                              "and truly loud in 2;"),
                    HasSubstr("at 0.001 it is off by 0.00 and 0.02 rad/s, but still truly loud "
                              "in 1.")));
  EXPECT_EQ(*results.value("too-fast"), value_of(3));
  EXPECT_EQ(*results.value("too-slow"), value_of(1));
  const Table& speeds = *results.table("quiet-speeds");
  EXPECT_EQ(speeds[1].number("at_0.25"), 8);
  EXPECT_EQ(speeds[1].number("fastest"), 5);
  EXPECT_EQ(results.chart("speed-gap")->series.size(), 3U);
}

TEST(Gradients, CountEveryPointOnceAndAreFlatNextToTheCount) {
  const Table table = gradients({0.25, 1e-7}, 6, 4);
  ASSERT_EQ(table.rows.size(), 12U * 6 * 4 * 2);
  each_row(table, [](const Row& row) {
    EXPECT_EQ(row.is("right") + row.is("wrong") + row.is("neither"), 1);
    EXPECT_TRUE(!row.is("flat") || row.is("neither"));
  });
  report::Results results;
  add_gradients(results, table);
  const Table& validity = *results.table("validity");
  EXPECT_LT(validity[0].number("flat"), 0.2);
  EXPECT_GT(validity[1].number("flat"), 0.95);
  EXPECT_EQ(results.chart("validity-trend")->heat_map->rows.size(), 12U);
}

TEST(Gradients, CountPointsWithoutATrendAmongAll) {
  Table table{"gradients",
              columns_named("smoothing,case,speed,flat,kink,sensitive,right,wrong,neither")};
  for (int k = 0; k < 10; ++k)
    table.add(0.25, "C1", 9.0, false, false, false, k < 3, k >= 3 && k < 6, k >= 6);
  table.add(0.25, "C1", 12.0, true, false, false, false, false, true);
  report::Results results;
  add_gradients(results, table);
  const Row row = (*results.table("validity"))[0];
  EXPECT_DOUBLE_EQ(row.number("right"), 3.0 / 11);
  EXPECT_DOUBLE_EQ(row.number("wrong"), 3.0 / 11);
  EXPECT_DOUBLE_EQ(row.number("no_trend"), 5.0 / 11);
  const auto& cells = results.chart("validity-trend")->heat_map->rows.at(0);
  EXPECT_EQ(cells, (std::vector<std::optional<double>>{50, std::nullopt}));
}

/// Drifts from x = 0.5 m at 0.1 m/s and swings by 0.5 m about that, so that it first turns at some
/// 1.5 m + 0.1 m/s pi / omega: the faster, the lower. The second swing hits the wall in
/// any case, about as fast as the counting limit.
const Scene swing =
    with(Scene{}, set::centrifugal_mass_radius(0.5), set::start(0.5, 0.1), set::wall_upper(1.6),
         set::restitution(0.5), set::counting_limit(1.3), set::revolutions(2));

/// [m] of the swing's top over the wall at a speed [rad/s].
double overshoot(double omega) {
  // x = 0.5 + 0.1 t + 0.5 (1 - cos(omega t)), first at rest where sin(omega t) = -0.2 / omega.
  const double angle = std::numbers::pi + std::asin(0.2 / omega);
  return 0.5 + 0.1 * angle / omega + 0.5 * (1 - std::cos(angle)) - 1.6;
}

/// What the page says of a graze, and that the gradient's reach is the distance from it.
TEST(Gradients, GrowWithTheInverseRootOfTheDistanceFromAGraze) {
  double grazing = 1, missed = 10;
  while (missed - grazing > 1e-14) {
    const double middle = 0.5 * (grazing + missed);
    (overshoot(middle) > 0 ? grazing : missed) = middle;
  }
  const auto slope = [&](double distance) {
    return surrogate_slope(at_speed(swing, grazing - distance * 18), 0.25, 18);
  };
  EXPECT_NEAR(slope(1e-9).slope / slope(1e-7).slope, 10, 0.5);
  EXPECT_NEAR(slope(-1e-9).slope, slope(-1e-7).slope, 1e-2 * std::abs(slope(-1e-7).slope));
  for (const double distance : {1e-7, 1e-9, -1e-7, -1e-9})
    EXPECT_NEAR(slope(distance).trust.reach / std::abs(distance), 1, 1e-2);
}

/// The change of f between two neighbouring numbers, found from its values at 17 points.
template <class Function>
double largest_jump(const Function& f) {
  std::vector<double> values;
  for (int k = 0; k <= 16; ++k) values.push_back(f(k / 16.0));
  return narrowed(steepest_piece(values), f).change();
}

TEST(Continuity, NarrowsAStepBesideASteepSlope) {
  const auto stair = [](double t) { return 0.2 * t * t + (t > 0.37 ? 0.3 : 0.0); };
  EXPECT_NEAR(largest_jump(stair), 0.3, 1e-15);
  EXPECT_LT(largest_jump([](double t) { return std::sin(20 * t); }), 1e-14);
  EXPECT_LT(largest_jump([](double t) { return std::sqrt(t); }), 1e-7);
}

TEST(Continuity, FindsTheCountsJumpsAndNoneOfTheSurrogate) {
  const Table table = changes({0.5, 0.25}, 162, 3);
  EXPECT_EQ(table.rows.size(), 162U);
  each_row(table, [](const Row& row) {
    EXPECT_LT(row.number("steepest"), largest_allowed);
    EXPECT_LT(row.number_if("strike").value_or(0), largest_allowed);
    // A root, or smoother; 0 would be a jump.
    EXPECT_GT(row.number_if("exponent").value_or(1), 0.4);
  });
  report::Results results;
  add_continuity(results, table);
  EXPECT_GT(number_in(*results.value("count-jumps")), 0.2);
  EXPECT_GT(number_in(*results.value("births")), 3);
  EXPECT_EQ(text_of(*results.value("continuous")), "Yes, up to rounding");
  const Table& continuity = *results.table("continuity");
  ASSERT_EQ(continuity.rows.size(), 4U);
  EXPECT_EQ(continuity[0].number("smoothing"), 0.5);
  EXPECT_EQ(continuity[0].text("where"), "steepest");
  EXPECT_EQ(continuity[0].number("segments") + continuity[2].number("segments"), 162);
}

TEST(Continuity, IsNotShownWhereAChangeIsTooLarge) {
  Table table{"changes", columns_named("smoothing,count_jumps,steepest,strike,exponent")};
  table.add(0.25, true, 1e-12, 2e-5, 0.1);
  table.add(0.25, false, 1e-12, std::nullopt, std::nullopt);
  report::Results results;
  add_continuity(results, table);
  EXPECT_EQ(text_of(*results.value("continuous")), "That is not shown");
  EXPECT_EQ(*results.value("jumps-larger"), value_of(1));
  EXPECT_EQ(*results.value("jump-worst"), value_of(2e-5));
  EXPECT_EQ(*results.value("count-jumps"), value_of(0.5));
  EXPECT_EQ(*results.value("exponents-low"), value_of(1));
}

TEST(Continuity, HasTheSameBitsForAnyNumberOfThreads) {
  const Table many = changes({0.25}, 54, 4);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(changes({0.25}, 54, 4).rows, many.rows);
}

/// x + y, subject to x^2 + y^2 <= 1, in [-2, 2] x [-2, 6].
Problem wide_disc() {
  Problem problem = disc();
  problem.name = "disc-C3";
  problem.upper[1] = 6;
  problem.smoothed = nullptr;
  return problem;
}

Family family_of(const Problem& problem) {
  return {problem.name, {{problem}}};
}

/// A function of one variable in [-1, 1] with what is said to be its slope.
template <class Function, class Slope>
Problem curve(Function function, Slope slope) {
  Problem problem =
      box_problem("curve-C1", 1, -1, 1, 0, [function](const Vector& x) { return function(x[0]); });
  differentiate_by(problem,
                   [slope](const Vector& x) -> Vector { return Vector::Constant(1, slope(x[0])); });
  return problem;
}

std::string cause(const Problem& problem, double point) {
  return derivatives_at("", problem, Vector::Constant(1, point), Vector::Ones(1))[0].text("cause");
}

/// How many rows of a function have a cause.
std::size_t with_cause(const Table& table, const char* function, const char* cause) {
  return where(where(table, "function", value_of(function)), "cause", value_of(cause)).rows.size();
}

TEST(Derivatives, AreComparedAlongADirectionOfTheUnitBox) {
  // At x = 1, y = 2.
  const Table found = derivatives_at("", wide_disc(), Vector{{0.75, 0.5}}, Vector{{0.6, -0.8}});
  ASSERT_EQ(found.rows.size(), 2U);
  const double exact[] = {4 * 0.6 + 8 * -0.8, 2 * 1 * 4 * 0.6 + 2 * 2 * 8 * -0.8};
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(found[k].number("exact"), exact[k], 1e-14);
    EXPECT_NEAR(found[k].number("difference"), exact[k], 1e-9);
    EXPECT_EQ(found[k].text("cause"), "none");
  }
}

TEST(Derivatives, ThatAreWrongAreFound) {
  Problem wrong = wide_disc();
  wrong.differentiate = [right = wrong.differentiate](const Vector& x) {
    Derivatives d = right(x);
    d.jacobian(0, 1) *= 1 + 1e-4;
    return d;
  };
  const Table table = derivatives({family_of(wrong)}, 200, 1);
  EXPECT_EQ(with_cause(table, "objective", "none"), 200U);
  const std::size_t unexplained = with_cause(table, "constraints", "unexplained");
  EXPECT_GT(unexplained, 180U);
  report::Results results;
  add_derivatives(results, table);
  EXPECT_EQ(results.table("unexplained")->rows.size(), unexplained);
  const Row constraints = (*results.table("derivatives"))[1];
  EXPECT_EQ(constraints.number("derivatives"), 200);
  EXPECT_EQ(*results.value("unexplained-outliers"), constraints["unexplained"]);
}

TEST(Derivatives, AtACornerAreExplainedByTheReachAlone) {
  Problem corner =
      curve([](double x) { return std::abs(x); }, [](double x) { return x > 0 ? 1 : -1; });
  const double near = 0.5 + 0.5e-7;  // shorter than the shortest step
  EXPECT_EQ(cause(corner, near), "unexplained");
  EXPECT_EQ(cause(corner, 0.7), "none");
  // If it knows how far its corner is:
  corner.differentiate = [differentiate = corner.differentiate](const Vector& x) {
    Derivatives d = differentiate(x);
    d.trust.reach = std::abs(x[0]) / 2;
    return d;
  };
  EXPECT_EQ(cause(corner, near), "reach");
}

TEST(Derivatives, OfNextToNothingAreFlatAndThoseThatDifferencesCannotTellAreRounding) {
  EXPECT_EQ(cause(curve([](double x) { return 5 + 1e-10 * x; }, [](double) { return 3e-10; }), 0.7),
            "flat");
  const Problem coarse =
      curve([](double x) { return 1.37e-7 * std::round(x / 1.37e-7); }, [](double) { return 1.0; });
  const Table table = derivatives({family_of(coarse)}, 1000, 1);
  EXPECT_GT(with_cause(table, "objective", "rounding"), 700U);
  EXPECT_EQ(with_cause(table, "objective", "reach"), 0U);
}

TEST(Derivatives, OfTheCasesSurrogatesHoldOnAnyNumberOfThreads) {
  Problem without = wide_disc();
  without.differentiate = nullptr;
  const std::vector<Family> of_machines = families_of(all_machines());
  const std::vector<Family> families = {of_machines[0], of_machines[1], family_of(without)};
  const Table table = derivatives(families, 72, 7);
  ASSERT_EQ(table.rows.size(), 36U + 2 * 36U);
  EXPECT_TRUE(where(table, "cause", value_of("unexplained")).rows.empty());
  each_row(aggregated(table, {"family", "function"}, {{{"half"}, "relative", median_of}}),
           [](const Row& row) { EXPECT_LT(row.number("half"), 1e-10) << row.text("family"); });
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(derivatives(families, 72, 7).rows, table.rows);
}

}  // namespace
}  // namespace ricochet::studies::surrogate
