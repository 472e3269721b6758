#include "src/studies/fireworks/study.h"

#include "solvers/fireworks/fireworks.h"
#include "solvers/library_solvers.h"
#include "tests/studies/pages.h"
#include "tests/support/test.h"

namespace ricochet::studies::fireworks {
namespace {

using testing::HasSubstr;

double value(const std::string& name, const Vector& x) {
  return benchmark_function(name, x.size()).evaluate(x).objective;
}

TEST(BenchmarkFunctions, HaveTheValuesOfTheirFormulas) {
  for (const char* name :
       {"Sphere", "Rastrigin", "Griewank", "Ellipse", "Cigar", "Tablet", "Ackley"}) {
    EXPECT_NEAR(value(name, Vector::Zero(30)), 0, 1e-14) << name;
  }
  EXPECT_EQ(value("Rosenbrock", Vector::Ones(30)), 0);
  EXPECT_EQ(value("Schwefel", Vector::Ones(30)), 0);
  const Vector x{{1, 2, 3}};
  EXPECT_EQ(value("Sphere", x), 14);
  EXPECT_EQ(value("Rosenbrock", x), 100 + 0 + 100 + 1);
  EXPECT_NEAR(value("Rastrigin", x), 14, 1e-12);
  EXPECT_NEAR(value("Griewank", x),
              1 + 14.0 / 4000 - std::cos(1) * std::cos(std::sqrt(2)) * std::cos(std::sqrt(3)),
              1e-14);
  EXPECT_NEAR(value("Ellipse", x), 1 + 100 * 4 + 1e4 * 9, 1e-9);
  EXPECT_EQ(value("Cigar", x), 1 + 13e4);
  EXPECT_EQ(value("Tablet", x), 13 + 1e4);
  EXPECT_EQ(value("Schwefel", x), 0 + (9 + 1) + (64 + 4));
  EXPECT_NEAR(value("Ackley", x), 20 - 20 * std::exp(-0.2 * std::sqrt(14.0 / 3)), 1e-12);
  EXPECT_THROW(benchmark_function("Spear", 3), std::out_of_range);
  const Problem moved = shifted_sphere(5, 2);
  EXPECT_EQ(moved.evaluate(Vector{{5, 5}}).objective, 0);
  EXPECT_EQ(moved.evaluate(Vector{{4, 7}}).objective, 5);
}

TEST(Moments, AgreeWithWhatChanceWouldBring) {
  const Moments moments = moments_of({1, 2, 3, 4, 5});
  EXPECT_DOUBLE_EQ(moments.mean, 3);
  EXPECT_DOUBLE_EQ(moments.deviation, std::sqrt(2.5));
  EXPECT_EQ(moments.runs, 5U);
  // t of 4 degrees, from tables
  const double reach = 2.7764451 * std::sqrt(2.5 * (1.0 / 5 + 1.0 / 10));
  EXPECT_TRUE(agrees(moments, {3 + 0.999 * reach, 10}));
  EXPECT_FALSE(agrees(moments, {3 + 1.001 * reach, 10}));
  EXPECT_FALSE(agrees(moments, {3 - 1.001 * reach, 10}));
  const double own = 2.7764451 * std::sqrt(2.5 / 5);  // another that is exact
  EXPECT_TRUE(agrees(moments, {3 + 0.999 * own, 10, 0}));
  EXPECT_FALSE(agrees(moments, {3 + 1.001 * own, 10, 0}));
  EXPECT_TRUE(agrees(moments_of({0, 0, 0}), {1e-14, 15})) << "both are zero";
}

TEST(Errors, AreThoseOfTheRunsNumberedFromOne) {
  Problem problem = shifted_sphere(7, 2);
  std::vector<double> expected;
  for (int number = 1; number <= 3; ++number) {
    const RunRecord record = run(problem, random_search(), {50}, number);
    expected.push_back(record.trace.back().true_values.objective);
  }
  const auto problem_again = [&] { return problem; };
  EXPECT_THAT(errors_of({{random_search(), problem_again}, {random_search(), problem_again}}, 50, 3,
                        "test"),
              testing::ElementsAre(expected, expected));
  problem.evaluate = [](const Vector&) -> Values { throw std::runtime_error("broken"); };
  EXPECT_THROW(errors_of({{random_search(), problem_again}}, 50, 1, "test"), std::runtime_error);
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
  for (const Solver& member : family) EXPECT_EQ(names.count(member.name), 1U) << member.name;
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
  EXPECT_EQ(biased, (std::set<std::string>{"bbfwa-tuned", "fireworks", "fireworks-as-printed",
                                           "fireworks-authors"}));
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
