#include "problems/classic/hock_schittkowski.h"

#include "problems/classic/formula.h"
#include "tests/problems/classic/claims.h"

namespace ricochet::classic {
namespace {

TEST(HockSchittkowski, HasThePublishedMinima) {
  const std::vector<Problem> problems = hock_schittkowski_problems();
  const auto rows = lines_published("published_values.csv", "hs-");
  ASSERT_EQ(problems.size(), rows.size());
  for (std::size_t i = 0; i < problems.size(); ++i) {
    const Problem& problem = problems[i];
    EXPECT_EQ(problem.name, rows[i][0]);
    const std::string& digits = rows[i][1];
    const double value = std::stod(digits);
    const auto point = digits.find('.');  // none: it is exact
    const double unit = point == std::string::npos
                            ? 1e-9
                            : std::pow(10.0, -static_cast<double>(digits.size() - 1 - point));
    const double off = rows[i][2].empty() ? 1.1 * unit : std::stod(rows[i][2]) * std::abs(value);
    if (problem.name == "hs-87") {
      EXPECT_LT(*problem.best_known, value - 1) << "just below a jump";
    } else {
      EXPECT_LE(std::abs(*problem.best_known - value), off) << problem.name;
    }
  }
}

TEST(HockSchittkowski, HasAnEquationInsideItsCircle) {
  const Problem circle = named(hock_schittkowski_problems(), "hs-7");
  EXPECT_EQ(true_values_at(circle, Vector::Zero(2)).violation, 3);
}

Vector numbers(const std::string& text) {
  std::istringstream words(text);
  const std::vector<double> all(std::istream_iterator<double>(words), {});
  return Eigen::Map<const Vector>(all.data(), static_cast<Eigen::Index>(all.size()));
}

/// Ours against other programs of the same problems: what they have says the file.
TEST(HockSchittkowskiValues, AreThoseOfIndependentProgramsToTenDigits) {
  const std::vector<Problem> problems = hock_schittkowski_problems();
  std::set<std::pair<std::string, std::string>> seen;
  std::size_t compared = 0;
  for (const auto& cell : lines_published("hock_schittkowski_values.csv", "hs-")) {
    SCOPED_TRACE(cell[0] + " at its " + cell[3] + " point");
    EXPECT_TRUE(seen.emplace(cell[0], cell[3]).second);
    const Problem problem = named(problems, cell[0]);
    const Eigen::Index equations = std::stoi(cell[1]);
    EXPECT_EQ(equations, problem.equalities);
    const Vector x = numbers(cell[4]), given = numbers(cell[6]);
    ASSERT_EQ(x.size(), problem.dimension());
    ASSERT_EQ(given.size(), problem.constraints);
    EXPECT_TRUE(cell[3] != "start" || (problem.start - x).cwiseAbs().maxCoeff() <= 1e-15);
    const Derivatives ours = problem.differentiate(x);
    Vector expected(1 + given.size());  // in our order and with our signs
    expected << std::stod(cell[5]), given.tail(equations), -given.head(given.size() - equations);
    ASSERT_EQ(ours.values.constraints.size(), given.size());
    Matrix slopes(expected.size(), problem.dimension());
    slopes << ours.gradient.transpose(), ours.jacobian;
    const Vector terms = slopes.cwiseAbs() * x.cwiseAbs();  // what may cancel
    const Vector off = (all_of(ours.values) - expected).cwiseAbs();
    for (Eigen::Index i = 0; i < off.size(); ++i, ++compared) {
      EXPECT_LE(off[i], 1e-10 * std::abs(expected[i]) + 1e-14 * std::max(1.0, terms[i])) << i;
    }
  }
  EXPECT_EQ(compared, 2605U);
  EXPECT_EQ(seen.size(), 5 * problems.size());
}

// The conditions of Karush, Kuhn and Tucker themselves, coordinate by coordinate.
TEST(Multipliers, BalanceTheGradientButForActiveBounds) {
  int looked = 0;
  for (const Problem& problem : hock_schittkowski_problems()) {
    if (problem.name == "hs-13") continue;  // see below
    if (problem.name == "hs-87") continue;  // its best point lies at a jump
    SCOPED_TRACE(problem.name);
    const std::optional<Vector> multipliers = multipliers_at_best(problem);
    ASSERT_TRUE(multipliers);
    ASSERT_EQ(multipliers->size(), problem.constraints);
    const Vector& best = *problem.best_point;
    const Derivatives d = problem.differentiate(best);
    const double small = 1e-10 * (1 + d.gradient.norm());
    for (Eigen::Index i = problem.equalities; i < problem.constraints; ++i) {
      EXPECT_GE((*multipliers)[i], -small);
      EXPECT_TRUE((*multipliers)[i] == 0 || d.values.constraints[i] > -1e-9);
    }
    const Vector left = d.gradient + d.jacobian.transpose() * *multipliers;
    for (Eigen::Index i = 0; i < best.size(); ++i) {
      const bool at_lower = best[i] - problem.lower[i] <= 1e-9;
      const bool at_upper = problem.upper[i] - best[i] <= 1e-9;
      EXPECT_TRUE(at_lower || left[i] < small) << "coordinate " << i;
      EXPECT_TRUE(at_upper || left[i] > -small) << "coordinate " << i;
    }
    ++looked;
  }
  EXPECT_EQ(looked, 114);
}

// Its feasible set ends in a cusp, at a bound: what is active there depends on one another.
TEST(HockSchittkowski, MeetsInOneProblemThoseOfFritzJohnAlone) {
  const Problem problem = named(hock_schittkowski_problems(), "hs-13");
  EXPECT_EQ(*problem.best_point, (Vector{{1, 0}}));
  EXPECT_EQ(problem.lower[1], 0);
  const Derivatives d = problem.differentiate(*problem.best_point);
  EXPECT_EQ(d.values.constraints, Vector::Zero(1));
  EXPECT_EQ(d.jacobian, (Matrix{{0, 1}}));
  EXPECT_EQ(d.gradient, (Vector{{-2, 0}}));
  EXPECT_FALSE(multipliers_at_best(problem));
}

}  // namespace
}  // namespace ricochet::classic
