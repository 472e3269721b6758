#include "problems/classic/hock_schittkowski.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>

#include "problems/classic/classic.h"
#include "src/core/verdict.h"
#include "tests/classic/claims.h"

namespace ricochet::classic {
namespace {

struct Published {
  const char* name;
  Vector start;
  double at_start;
  double best;
};

// Source: Hock and Schittkowski (1981), to the digits given there.
TEST(HockSchittkowski, HasThePublishedValues) {
  const std::vector<Problem> problems = classic_problems();
  const auto all = [](Eigen::Index n, double value) { return Vector::Constant(n, value).eval(); };
  const std::vector<Published> published = {
      {"hs-1", Vector{{-2, 1}}, 909, 0},
      {"hs-2", Vector{{-2, 1}}, 909, 0.0504261879},
      {"hs-3", Vector{{10, 1}}, 1.00081, 0},
      {"hs-4", Vector{{1.125, 0.125}}, 3.323568, 2.6666666667},
      {"hs-5", all(2, 0), 1, -1.9132229550},
      {"hs-6", Vector{{-1.2, 1}}, 4.84, 0},
      {"hs-7", Vector{{2, 2}}, std::log(5.0) - 2, -1.7320508076},
      {"hs-10", Vector{{-10, 10}}, -20, -1},
      {"hs-11", Vector{{4.9, 0.1}}, -24.98, -8.498464223},
      {"hs-12", all(2, 0), 0, -30},
      {"hs-15", Vector{{-2, 1}}, 909, 306.5},
      {"hs-18", Vector{{2, 2}}, 4.04, 5},
      {"hs-21", Vector{{-1, -1}}, -98.99, -99.96},
      {"hs-22", Vector{{2, 2}}, 1, 1},
      {"hs-23", Vector{{3, 1}}, 10, 2},
      {"hs-24", Vector{{1, 0.5}}, -0.01336459, -1},
      {"hs-29", all(3, 1), -1, -22.627417},
      {"hs-30", all(3, 1), 3, 1},
      {"hs-31", all(3, 1), 19, 6},
      {"hs-33", Vector{{0, 0, 3}}, -3, -4.585786438},
      {"hs-34", Vector{{0, 1.05, 2.9}}, 0, -0.8340324452},
      {"hs-35", all(3, 0.5), 2.25, 0.1111111111},
      {"hs-36", all(3, 10), -1000, -3300},
      {"hs-37", all(3, 10), -1000, -3456},
      {"hs-38", Vector{{-3, -1, -3, -1}}, 19192, 0},
      {"hs-43", all(4, 0), 0, -44},
      {"hs-44", all(4, 0), 0, -15},
      {"hs-64", all(3, 1), 266035, 6299.842428},
      {"hs-65", Vector{{-5, 5, 0}}, 136.1111111, 0.9535288567},
      {"hs-66", Vector{{0, 1.05, 2.9}}, 0.58, 0.5181632741},
      {"hs-76", all(4, 0.5), -1.25, -4.681818182},
      {"hs-100", Vector{{1, 2, 0, 4, 0, 1, 1}}, 714, 680.6300573},
      {"hs-113", Vector{{2, 3, 5, 5, 1, 2, 7, 3, 6, 10}}, 753, 24.3062091},
  };
  for (const Published& p : published) {
    const Problem problem = named(problems, p.name);
    EXPECT_NEAR(problem.evaluate(p.start).objective, p.at_start, 5e-7 * std::abs(p.at_start) + 1e-6)
        << p.name;
    EXPECT_NEAR(*problem.best_known, p.best, 1e-8 * std::max(1.0, std::abs(p.best))) << p.name;
    EXPECT_EQ(problem.start, p.start.cwiseMax(problem.lower).cwiseMin(problem.upper)) << p.name;
  }
  const auto count = std::count_if(problems.begin(), problems.end(), [](const Problem& problem) {
    return problem.name.starts_with("hs-");
  });
  EXPECT_EQ(count, static_cast<std::ptrdiff_t>(published.size()));
}

// The KKT conditions say nothing of constraints that are inactive at the optimum.
TEST(HockSchittkowski, HasConstraintsWorkedByHand) {
  struct Worked {
    const char* name;
    Vector x;
    Vector slack;  // as in the source, >= 0 where feasible; of an equation minus what must be 0
  };
  const Vector two{{2, 3}};
  const Vector three{{1, 2, 3}};
  const Vector four{{1, 2, 3, 4}};
  const double root = std::sqrt(3.0);
  const std::vector<Worked> all = {
      {"hs-6", two, Vector{{10}}},
      {"hs-7", two, Vector{{-30}}},
      {"hs-10", two, Vector{{-12 + 12 - 9 + 1}}},
      {"hs-11", two, Vector{{-1}}},
      {"hs-12", two, Vector{{0}}},
      {"hs-15", two, Vector{{5, 11}}},
      {"hs-18", two, Vector{{-19, -12}}},
      {"hs-21", two, Vector{{7}}},
      {"hs-22", two, Vector{{-3, -1}}},
      {"hs-23", two, Vector{{4, 12, 36, 1, 7}}},
      {"hs-24", Vector{{3, 0}}, Vector{{root, 3, 3}}},
      {"hs-24", Vector{{3, root}}, Vector{{0, 6, 0}}},
      {"hs-29", three, Vector{{48 - 1 - 8 - 36}}},
      {"hs-30", three, Vector{{4}}},
      {"hs-31", three, Vector{{1}}},
      {"hs-33", three, Vector{{4, 10}}},
      {"hs-34", Vector{{0, 2, 9}}, Vector{{1, 9 - std::exp(2.0)}}},
      {"hs-35", three, Vector{{-6}}},
      {"hs-36", three, Vector{{61}}},
      {"hs-37", three, Vector{{61, 11}}},
      {"hs-43", four, Vector{{-20, -35, -6}}},
      {"hs-44", four, Vector{{3, 6, 1, -2, -3, -2}}},
      {"hs-64", Vector{{4, 32, 120}}, Vector{{-2}}},
      {"hs-65", three, Vector{{34}}},
      {"hs-66", Vector{{0, 2, 9}}, Vector{{1, 9 - std::exp(2.0)}}},
      {"hs-76", four, Vector{{-7, -3, 12.5}}},
      {"hs-100", Vector{{1, 2, 0, 4, 0, 1, 1}}, Vector{{13, 265, 171, 4}}},
      {"hs-100", Vector{{1, 1, 1, 1, 1, 1, 1}}, Vector{{112, 262, 174, 2}}},
      {"hs-113", Vector{{2, 3, 5, 5, 1, 2, 7, 3, 6, 10}}, Vector{{76, 117, 12, 105, 5, 9, 4, 10}}},
  };
  const std::vector<Problem> problems = classic_problems();
  for (const Worked& worked : all) {
    const Vector constraints = named(problems, worked.name).evaluate(worked.x).constraints;
    ASSERT_EQ(constraints.size(), worked.slack.size()) << worked.name;
    EXPECT_LT((constraints + worked.slack).norm(), 1e-12) << worked.name;
  }
}

TEST(HockSchittkowski, TellsEquationsFromInequalities) {
  for (const Problem& problem : classic_problems()) {
    const bool has_one = problem.name == "hs-6" || problem.name == "hs-7";
    EXPECT_EQ(problem.equalities, has_one ? 1 : 0) << problem.name;
  }
  const Problem circle = named(classic_problems(), "hs-7");
  EXPECT_EQ(truth_at(circle, Vector::Zero(2)).violation, 3);  // on its inner side
}

TEST(HockSchittkowski, HasStartsWithinTheirBoundsButForThree) {
  const std::vector<Problem> problems = classic_problems();
  EXPECT_EQ(named(problems, "hs-2").start, (Vector{{-2, 1.5}}));
  EXPECT_EQ(named(problems, "hs-21").start, (Vector{{2, -1}}));
  EXPECT_EQ(named(problems, "hs-65").start, (Vector{{-4.5, 4.5, 0}}));
}

/// The gradients of the constraints and bounds that hold with equality, one a row; equations first.
Matrix active(const Problem& problem, const Derivatives& d) {
  std::vector<Vector> rows;
  for (Eigen::Index i = 0; i < problem.constraints; ++i) {
    if (d.values.constraints[i] > -1e-9) rows.emplace_back(d.jacobian.row(i).transpose());
  }
  for (Eigen::Index i = 0; i < problem.dimension(); ++i) {
    const Vector axis = Vector::Unit(problem.dimension(), i);
    if ((*problem.best_point)[i] - problem.lower[i] < 1e-9) rows.emplace_back(-axis);
    if (problem.upper[i] - (*problem.best_point)[i] < 1e-9) rows.emplace_back(axis);
  }
  Matrix result(static_cast<Eigen::Index>(rows.size()), problem.dimension());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    result.row(static_cast<Eigen::Index>(i)) = rows[i].transpose();
  }
  return result;
}

TEST(HockSchittkowski, MeetsTheConditionsOfKarushKuhnAndTucker) {
  for (const Problem& problem : classic_problems()) {
    if (!problem.name.starts_with("hs-")) continue;
    const Derivatives d = problem.differentiate(*problem.best_point);
    const Matrix rows = active(problem, d);
    const double size = 1 + d.gradient.norm();
    if (rows.rows() == 0) {
      EXPECT_LT(d.gradient.norm(), 1e-12) << problem.name;
      continue;
    }
    const Vector multipliers =
        rows.transpose().completeOrthogonalDecomposition().solve(-d.gradient);
    EXPECT_LT((d.gradient + rows.transpose() * multipliers).norm(), 1e-12 * size) << problem.name;
    const Eigen::Index inequalities = rows.rows() - problem.equalities;
    if (inequalities == 0) continue;
    EXPECT_GE(multipliers.tail(inequalities).minCoeff(), -1e-12 * size) << problem.name;
  }
}

}  // namespace
}  // namespace ricochet::classic
