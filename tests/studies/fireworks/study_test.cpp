#include "src/studies/fireworks/study.h"

#include "solvers/fireworks/fireworks.h"
#include "solvers/library_solvers.h"
#include "tests/studies/pages.h"

namespace ricochet::studies::fireworks {
namespace {

TEST(BenchmarkFunctions, HaveTheValuesOfTheirFormulas) {
  struct Row {
    const char* name;
    double at_123;       ///< at (1, 2, 3)
    double optimum = 0;  ///< in every coordinate
  };
  const auto cosines = std::cos(1) * std::cos(std::sqrt(2)) * std::cos(std::sqrt(3));
  for (const auto& [name, at_123, optimum] :
       {Row{"Sphere", 14},
        {"Rosenbrock", 100 + 0 + 100 + 1, 1},
        {"Rastrigin", 14},
        {"Griewank", 1 + 14.0 / 4000 - cosines},
        {"Ellipse", 1 + 100 * 4 + 1e4 * 9},
        {"Cigar", 1 + 13e4},
        {"Tablet", 13 + 1e4},
        {"Schwefel", 0 + (9 + 1) + (64 + 4), 1},
        {"Ackley", 20 - 20 * std::exp(-0.2 * std::sqrt(14.0 / 3))}}) {
    const auto value = [&, &name = name](const Vector& x) {
      return benchmark_function(name, x.size()).evaluate(x).objective;
    };
    EXPECT_NEAR(value(Vector{{1, 2, 3}}), at_123, 1e-13 * (1 + at_123)) << name;
    EXPECT_NEAR(value(Vector::Constant(30, optimum)), 0, 1e-14) << name;
  }
  EXPECT_THROW(benchmark_function("Spear", 3), std::out_of_range);
  const Problem moved = shifted_sphere(5, 2);
  EXPECT_EQ(moved.evaluate(Vector{{5, 5}}).objective, 0);
  EXPECT_EQ(moved.evaluate(Vector{{4, 7}}).objective, 5);
}

TEST(Moments, AgreeWithWhatChanceWouldBring) {
  const Moments moments = moments_of({1, 2, 3, 4, 5});
  EXPECT_THAT(moments, FieldsAre(3, testing::DoubleEq(std::sqrt(2.5)), 5));
  const double t = 2.7764451;  // of 4 degrees, from tables
  for (const double sign : {-1, 1}) {
    const double reach = sign * t * std::sqrt(2.5 * (1.0 / 5 + 1.0 / 10));
    EXPECT_TRUE(agrees(moments, {3 + 0.999 * reach, 10}));
    EXPECT_FALSE(agrees(moments, {3 + 1.001 * reach, 10}));
    const double own = sign * t * std::sqrt(2.5 / 5);  // another that is exact
    EXPECT_TRUE(agrees(moments, {3 + 0.999 * own, 10, 0}));
    EXPECT_FALSE(agrees(moments, {3 + 1.001 * own, 10, 0}));
  }
  EXPECT_TRUE(agrees(moments_of({0, 0, 0}), {1e-14, 15})) << "both are zero";
}

TEST(Errors, AreThoseOfTheRunsNumberedFromOne) {
  Problem problem = shifted_sphere(7, 2);
  std::vector<double> expected;
  for (int number = 1; number <= 3; ++number) {
    const RunRecord record = run(problem, random_search(), {50}, number);
    expected.push_back(record.trace.back().true_values.objective);
  }
  const Entry entry{random_search(), [&] { return problem; }};
  EXPECT_THAT(errors_of({entry, entry}, 50, 3, "test"), ElementsAre(expected, expected));
  problem.evaluate = [](const Vector&) -> Values { throw std::runtime_error("broken"); };
  EXPECT_THROW(errors_of({entry}, 50, 1, "test"), std::runtime_error);
}

/// All parts of the study, of next to no runs.
const report::Results& made() {
  static const report::Results results = compared_with_published({3, 2, 2000});
  return results;
}

Table of(const char* solver) {
  return where(*made().table("results"), "solver", value_of(solver));
}

TEST(FireworksStudy, HasARowForEveryMemberOfTheFamily) {
  std::set<std::string> names;
  each_row(*made().table("variants"), [&](const Row& row) {
    EXPECT_TRUE(names.insert(row.text("solver")).second);
    EXPECT_FALSE(row.text("what").empty());
  });
  const auto family = ricochet::fireworks::family();
  for (const Solver& member : family) EXPECT_TRUE(names.contains(member.name)) << member.name;
  EXPECT_EQ(names.size(), family.size() + 1);  // an interpretation that is no solver of its own
}

TEST(FireworksStudy, ReproducesTheSevenZerosOf2010) {
  // Table 3 of Tan and Zhu has nine functions, seven of them with a mean of 0.000000.
  for (const char* solver :
       {"fireworks", "fireworks-authors", "fireworks-authors with round(d U)"}) {
    const Table own = of(solver);
    ASSERT_EQ(own.rows.size(), 9U) << solver;
    int zeros = 0;
    each_row(own, [&](const Row& row) {
      if (row.number("published") > 0) return;
      ++zeros;
      EXPECT_LT(row.number("mean"), 5e-7) << row.text("function");
      EXPECT_TRUE(row.is("agrees")) << row.text("function");
    });
    EXPECT_EQ(zeros, 7) << solver;
  }
}

TEST(FireworksStudy, SeesWhoFavoursTheOrigin) {
  std::set<std::string> biased;
  each_row(*made().table("variants"), [&](const Row& row) {
    if (row.is("biased")) biased.insert(row.text("solver"));
  });
  // With two sparks the box around the firework shrinks before it has gone far.
  EXPECT_THAT(biased,
              ElementsAre("bbfwa-tuned", "fireworks", "fireworks-as-printed", "fireworks-authors"));
  EXPECT_EQ(made().table("shift")->rows.size(), 13U * 6U);
}

TEST(FireworksStudy, ComparesAllThatHasFigures) {
  if (of("efwa").rows.empty()) GTEST_SKIP() << "built without pagmo";
  for (const char* solver : {"efwa", "dynfwa", "bbfwa", "lotfwa"})
    EXPECT_EQ(of(solver).rows.size(), 6U) << solver;
  EXPECT_EQ(of("lotfwa")[1].number("published"), 14.6);
  EXPECT_EQ(made().table("results")->rows.size(), 3U * 9U + 4U * 6U);
  const Row lotfwa = row_of(*made().table("variants"), "solver", "lotfwa");
  EXPECT_EQ(lotfwa.number("compared"), 6);
  EXPECT_EQ(lotfwa.number("agreeing"), where(of("lotfwa"), "agrees", true).rows.size());
}

TEST(FireworksStudy, FillsItsPage) {
  report::Results results = made();
  results.set("quick", std::optional<std::string>());
  const auto files = study_page("fireworks", results).files;
  EXPECT_TRUE(files.contains("shift.svg"));
  EXPECT_THAT(files.at("summary.md"), HasSubstr("| fireworks | Sphere |"));
  EXPECT_THAT(files.at("index.html"),
              HasSubstr("<a href=\"../comparison/index.html\">comparison</a>"));
}

}  // namespace
}  // namespace ricochet::studies::fireworks
