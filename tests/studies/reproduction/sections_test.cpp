#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/random.h"
#include "src/studies/paper/theory.h"
#include "src/studies/reproduction/study.h"
#include "tests/studies/pages.h"
#include "tests/support/scenes.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;

/// What a section adds for these arguments.
template <class Section, class... Arguments>
report::Results made_by(Section section, const Arguments&... arguments) {
  report::Results results;
  section(arguments..., results);
  return results;
}

/// Two disturbances, two frictions, two restitutions, which change the fastest.
report::Results concluded(const std::vector<double>& means) {
  Table grid{"grid", columns_named("restitution,friction,disturbance,mean")};
  std::size_t k = 0;
  for (const double disturbance : {0.0, 1.0})
    for (const double friction : {0.1, 0.4})
      for (const double restitution : {0.1, 0.9})
        grid.add(restitution, friction, disturbance, means.at(k++));
  return made_by(add_conclusions, grid);
}

TEST(Conclusions, HoldBetweenTheNeighboursThatChangeAsClaimed) {
  struct Grid {
    std::vector<double> means;  // mu .1, mu .4, then with disturbance
    std::string said;
    std::vector<std::vector<double>> found;  // agree, disagree, least and largest ratio
  };
  for (const auto& [means, said, found] : {
           Grid{{4, 40, 3, 30, 8, 60, 6, 45},
                "(B) holds between all 2 neighbours that differ; (C) holds",
                {{2, 0, 10, 10}, {2, 0, 4.0 / 3, 4.0 / 3}, {4, 0, 1.5, 2}}},
           Grid{{4, 2, 3, 30, 8, 60, 2, 45},
                "(A) fails between 1 of 2; (B) fails between 1 of 2; (C) fails between 1 of 4.",
                {{1, 1, 0.5, 10}, {1, 1, 1.0 / 15, 4.0 / 3}, {3, 1, 2.0 / 3, 30}}},
           Grid{std::vector<double>(8, 4), "", {{0, 0, 1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}}},
       }) {
    const report::Results results = concluded(means);
    EXPECT_THAT(text_of(*results.value("conclusions")), HasSubstr(said));
    for (std::size_t k = 0; k < 3; ++k) {
      const Row row = (*results.table("conclusions"))[k];
      EXPECT_THAT((std::vector{row.number("agree"), row.number("disagree"), row.number("weakest"),
                               row.number("strongest")}),
                  testing::Pointwise(testing::DoubleEq(), found[k]));
    }
    report::check(*results.chart("grid"));
    EXPECT_EQ(results.chart("grid")->heat_map->rows[1][1], means[3]) << "friction 0.4, e 0.9";
  }
}

TEST(Conclusions, RestOnTheMeanOfTheCountsOverTheSpeeds) {
  const Scene interpretation = exploratory_scene();
  const Table grid = count_grid(interpretation, 3.0, true);
  ASSERT_EQ(grid.rows.size(), 5U * 4 * 3);
  const Scene scene = scene_of({"", 0.9, 0.2, 1, {}}, interpretation);
  double sum = 0;
  for (const double omega : {3.0, 6.0, 9.0, 12.0, 15.0, 18.0}) sum += count_at(scene, omega);
  const Table columns = only(grid, {"restitution", "friction", "disturbance", "mean"});
  EXPECT_EQ(columns.rows[2 * 20 + 5 + 4], (std::vector<Value>{0.9, 0.2, 1.0, sum / 6}));
}

CaseStudy study_of(const char* id) {
  CaseStudy c{find_case(id), scene_of(find_case(id), default_interpretation().scene), {}, {}, {}};
  c.borders.quiet = quiet_up_to(c.scene, quiet_per_turn, {slowest_speed, fastest_speed});
  return c;
}

const report::Results& levers() {
  static const report::Results results =
      made_by(add_levers, std::vector{study_of("C1"), study_of("C4"), study_of("C9")},
              default_interpretation(), true, fastest_speed);
  return results;
}

const report::Series& curve(const char* chart, const std::string& label) {
  return *std::ranges::find(levers().chart(chart)->series, label, &report::Series::label);
}

double speed_at(const report::Series& series, double position) {
  return std::ranges::find(series.samples, position, &report::Sample::position)->value.value();
}

TEST(Levers, OfRestitutionMeetThePapersCasesAndFall) {
  const report::Series& rough =
      curve("threshold-over-restitution", "friction 0.4, disturbance 0 N");
  EXPECT_EQ(speed_at(rough, 0.9), study_of("C4").borders.quiet);
  EXPECT_EQ(speed_at(curve("threshold-over-restitution", "friction 0.1, disturbance 0 N"), 0.1),
            study_of("C1").borders.quiet);
  EXPECT_EQ(rough.samples.front().position, 0.05);
  EXPECT_FALSE(rough.samples.front().value) << "quiet at every speed tried";
  for (std::size_t i = 2; i < rough.samples.size(); ++i)
    EXPECT_LT(rough.samples[i].value, rough.samples[i - 1].value);
  const auto& all = levers().chart("threshold-over-restitution")->series;
  EXPECT_EQ(all.size(), 3U) << "coarse ones have no disturbance; and the paper's points";
  EXPECT_TRUE(all.back().dark);
}

TEST(Levers, OfTheCountingLimitAreThoseOfSuchMachines) {
  const char* by_limit = "threshold-over-counting-limit";
  EXPECT_EQ(levers().chart(by_limit)->series.size(), 2U) << "only without disturbance";
  const report::Series& series = curve(by_limit, "C1: restitution 0.1, friction 0.1");
  const double own = default_interpretation().scene.counting_limit;
  EXPECT_EQ(speed_at(series, own / 1e-3), study_of("C1").borders.quiet);
  Scene scene = study_of("C1").scene;
  std::string speeds;
  for (const double limit : {1e-3, 3e-3, own, 10e-3}) {
    scene.counting_limit = limit;
    const double speed = *quiet_up_to(scene, quiet_per_turn, {slowest_speed, fastest_speed});
    EXPECT_EQ(speed_at(series, limit / 1e-3), speed);
    speeds += fmt::format("{}{:.2f}", speeds.empty() ? "" : limit == 10e-3 ? " and " : ", ", speed);
  }
  EXPECT_THAT(text_of(*levers().value("moves")), HasSubstr("C1 is quiet up to " + speeds));
  const double least = speed_at(series, 10) / speed_at(series, 1);
  EXPECT_THAT(levers().chart(by_limit)->title, HasSubstr(fmt::format("{:.1f} times", least)));
  EXPECT_EQ(levers().chart(by_limit)->lines.at(0).label, "fitted");
}

/// Dimensions: lengths, times and masses have no scale of their own. Start and window do not matter
/// in the long run, and the pull hardly does.
TEST(Levers, HaveExponentsThatAddUpAsTheirDimensionsSayTheLargestFirst) {
  const Table& exponents = *levers().table("exponents");
  EXPECT_FALSE(exponents.has("C9")) << "it is disturbed";
  for (const char* id : {"C1", "C4"}) {
    std::map<std::string, double> of;
    each_row(exponents, [&](const Row& row) { of[row.text("constant")] = row.number(id); });
    const double drive = of["centrifugal mass radius"] + of["slider mass radius"];
    const double held = of["normal force"] + of["pull"];
    EXPECT_NEAR(drive + held + of["clearance"] + of["counting limit"], 0, 5e-3) << id;
    EXPECT_NEAR(of["mass"] + drive + held, 0, 5e-3) << id;
    EXPECT_NEAR(2 * held + of["counting limit"], 1, 5e-3) << id;
    EXPECT_GT(std::abs(of["counting limit"]), 0.1) << id;
  }
  double largest = 10;
  std::set<std::string> fitted;
  each_row(exponents, [&](const Row& row) {
    const double most = std::max(std::abs(row.number("C1")), std::abs(row.number("C4")));
    EXPECT_LE(most, largest);
    largest = most;
    if (row.text("known") == "fitted") fitted.insert(row.text("constant"));
  });
  EXPECT_THAT(fitted, ElementsAre("centrifugal mass radius", "clearance", "counting limit"));
}

/// The paper's cases, with thresholds twice the formula's.
std::vector<CaseStudy> cases_by_formula() {
  std::vector<CaseStudy> cases;
  for (const Case& it : all_cases()) {
    CaseStudy& c = cases.emplace_back();
    c.the_case = it;
    c.score.threshold =
        2 * std::sqrt((1 - it.restitution) / (1 + it.restitution)) * std::exp(it.friction);
  }
  return cases;
}

TEST(Theory, FitsEveryFormulaToBothThresholds) {
  const report::Results results = made_by(add_theory, cases_by_formula());
  const Table& formulas = *results.table("formulas");
  ASSERT_EQ(formulas.rows.size(), all_formulas().size());
  EXPECT_EQ(formulas[0].text("formula"), "w = c");
  EXPECT_NEAR(formulas[0].number("explained"), 0, 1e-12);
  const Row row = row_of(formulas, "formula", "w = c √R exp(k μ)");
  EXPECT_NEAR(row.number("computed_error"), 0, 1e-12) << "that is how they were made";
  EXPECT_NEAR(row.number("computed_left_out"), 0, 1e-12);
  EXPECT_GT(row.number("left_out"), row.number("error"));
  EXPECT_EQ(*results.value("formula.error"), row["error"]);
  // By hand: 7.56 and 1.45 from the ten thresholds.
  EXPECT_EQ(row.text("constants"), "c = 7.56, k = 1.45");
}

TEST(Theory, LeavesOutWhatIsNotComputed) {
  auto cases = cases_by_formula();
  for (CaseStudy& c : cases) c.score.threshold.reset();
  const report::Results none = made_by(add_theory, cases);
  EXPECT_FALSE((*none.table("formulas"))[1].number_if("computed_error"));
  EXPECT_TRUE((*none.table("formulas"))[1].number_if("error"));
}

Vector vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Vector>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// The least distances of lists from some values.
struct LeastDistances {
  Vector values;
  double squared = 1e9, largest = 1e9;

  void add(const Vector& list) {
    squared = std::min(squared, (list - values).squaredNorm());
    largest = std::min(largest, (list - values).lpNorm<Eigen::Infinity>());
  }
};

TEST(IsotonicBound, IsThatOfAllOrderedLists) {
  Random random(1);
  for (int trial = 0; trial < 30; ++trial) {
    std::vector<AtMost> order;  // pairs by rising place, so that there is no circle
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        if (uniform(random) < 0.5) order.push_back({i, j});
      }
    }
    const auto is_ordered = [&](const std::vector<double>& list) {
      return std::ranges::all_of(
          order, [&](const AtMost& o) { return list[o.lower] <= list[o.upper] + 1e-12; });
    };
    std::vector<double> values(4);
    for (double& v : values) v = std::floor(5 * uniform(random));
    const OrderBound bound = isotonic_bound(values, order);
    EXPECT_TRUE(is_ordered(bound.nearest));
    const Vector rest = vector_of(values) - vector_of(bound.nearest);
    EXPECT_NEAR(bound.root_mean_square, std::sqrt(rest.squaredNorm() / 4), 1e-12);
    LeastDistances least{vector_of(values)};
    // Every list of four numbers out of 0, 1/2, ..., 4.
    for (int code = 0; code < 9 * 9 * 9 * 9; ++code) {
      std::vector<double> list;
      for (const int unit : {1, 9, 81, 729}) list.push_back(0.5 * (code / unit % 9));
      if (!is_ordered(list)) continue;
      least.add(vector_of(list));
      // Nearest in a convex set: no other way from it leads nearer.
      EXPECT_LE(rest.dot(vector_of(list) - vector_of(bound.nearest)), 1e-9);
    }
    EXPECT_LE(rest.squaredNorm(), least.squared + 1e-9);
    EXPECT_NEAR(bound.largest, least.largest, 1e-12);  // a half of whole numbers' difference
  }
}

TEST(ConcaveBound, IsThatOfAllConcaveThresholds) {
  const std::vector<double> y = {std::log(9.0), std::log(8.0), std::log(7.3)};
  const OrderBound bound = concave_bound(y, 0.1);
  LeastDistances least{vector_of(y)};
  constexpr int steps = 100;
  const auto near = [&](std::size_t i, int k) { return y[i] + 0.12 * (2.0 * k / steps - 1); };
  for (int a = 0; a <= steps; ++a) {
    for (int b = 0; b <= steps; ++b) {
      for (int c = 0; c <= steps; ++c) {
        const Vector list{{near(0, a), near(1, b), near(2, c)}};
        if (list[1] >= 0.9 * list[0] + 0.1 * list[2]) least.add(list);
      }
    }
  }
  EXPECT_NEAR(bound.root_mean_square, std::sqrt(least.squared / 3), 0.0015);
  EXPECT_LE(bound.root_mean_square, std::sqrt(least.squared / 3) + 1e-12);
  EXPECT_NEAR(bound.largest, least.largest, 0.0025);
  EXPECT_LE(bound.largest, least.largest + 1e-12);
  EXPECT_EQ(concave_bound({1, 1, 0}, 0.5).largest, 0) << "concave";
}

/// By hand, from the paper's thresholds.
TEST(OrderBound, OfThePaperRestsOnFewOfItsThresholds) {
  const report::Results results = made_by(add_bounds);
  const Table& bounds = *results.table("bounds");
  ASSERT_EQ(bounds.rows.size(), 3U);
  // C10 is above C6, of which half is each one's share.
  const double half = std::log(2.0 / 1.9) / 2;
  EXPECT_NEAR(bounds[0].number("largest"), half, 1e-12);
  EXPECT_NEAR(bounds[0].number("root_mean_square"), std::sqrt(2 * half * half / 10), 1e-12);
  // C5 is below the chord from C1 to C9.
  const double below = 0.9 * std::log(9.0) + 0.1 * std::log(7.3) - std::log(8.0);
  EXPECT_NEAR(bounds[1].number("largest"), below / 2, 1e-12);
  // The means of each machine.
  EXPECT_NEAR(bounds[2].number("largest"), std::log(9 / 7.3) / 2, 1e-12);
  double squares = 0;
  for (const Vector& machine :
       {Vector{{9, 8, 7.3}}, Vector{{2, 1.9, 2}}, Vector{{13, 11.9}}, Vector{{3.1, 3}}}) {
    const Eigen::ArrayXd logarithms = machine.array().log();
    squares += (logarithms - logarithms.mean()).square().sum();
  }
  EXPECT_NEAR(bounds[2].number("root_mean_square"), std::sqrt(squares / 10), 1e-12);
  EXPECT_EQ(*results.value("steepest.case"), value_of("C1"));
  EXPECT_NEAR(*number_in(*results.value("steepest.share")), std::log(9.0 / 8) / std::log(9 / 7.3),
              1e-12);
}

}  // namespace
}  // namespace ricochet::studies::reproduction
