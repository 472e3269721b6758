#include "problems/classic/hock_schittkowski.h"

#include "problems/classic/formula.h"
#include "ricochet/run.h"
#include "tests/problems/classic/claims.h"
#include "tests/support/test.h"

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

TEST(HockSchittkowski, TellsEquationsFromInequalities) {
  for (const Problem& problem : hock_schittkowski_problems()) {
    EXPECT_LE(problem.equalities, std::min(problem.constraints, problem.dimension()))
        << problem.name;
  }
  const Problem circle = named(hock_schittkowski_problems(), "hs-7");
  EXPECT_EQ(true_values_at(circle, Vector::Zero(2)).violation, 3);  // on its inner side
}

/// One line of hock_schittkowski_values.csv.
struct Row {
  std::string problem;
  Eigen::Index equations;
  std::string point;
  Vector x;
  double objective;
  Vector constraints;  ///< in our order and with our signs
};

Vector numbers(const std::string& text) {
  std::istringstream words(text);
  std::vector<double> values;
  for (std::string word; words >> word;) values.push_back(std::stod(word));
  return Eigen::Map<const Vector>(values.data(), static_cast<Eigen::Index>(values.size()));
}

Row row_of(const std::vector<std::string>& cell) {
  const Eigen::Index equations = std::stoi(cell[1]);
  const Vector given = numbers(cell[6]);
  Vector constraints(given.size());
  constraints << given.tail(equations), -given.head(given.size() - equations);
  return {cell[0], equations, cell[3], numbers(cell[4]), std::stod(cell[5]), constraints};
}

/// Ours against other programs of the same problems: what they have says the file.
TEST(HockSchittkowskiValues, AreThoseOfIndependentProgramsToTenDigits) {
  const std::vector<Problem> problems = hock_schittkowski_problems();
  std::set<std::pair<std::string, std::string>> seen;
  std::size_t compared = 0;
  for (const auto& cells : lines_published("hock_schittkowski_values.csv", "hs-")) {
    const Row row = row_of(cells);
    SCOPED_TRACE(row.problem + " at its " + row.point + " point");
    EXPECT_TRUE(seen.emplace(row.problem, row.point).second);
    const Problem problem = named(problems, row.problem);
    ASSERT_EQ(row.x.size(), problem.dimension());
    if (row.point == "start") {
      EXPECT_LE((problem.start - row.x).cwiseAbs().maxCoeff(), 1e-15);
    }
    EXPECT_EQ(row.equations, problem.equalities);
    const Derivatives ours = problem.differentiate(row.x);
    ASSERT_EQ(ours.values.constraints.size(), row.constraints.size());
    const Vector expected = all_of({row.objective, row.constraints});
    Matrix slopes(expected.size(), problem.dimension());
    slopes << ours.gradient.transpose(), ours.jacobian;
    const Vector terms = slopes.cwiseAbs() * row.x.cwiseAbs();  // what may cancel
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

// Worked by hand from the first-order conditions.
TEST(Multipliers, AreThoseWorkedByHand) {
  const std::map<std::string, double> sums = {{"hs-32", 2}, {"hs-39", 2}, {"hs-53", 440.0 / 43}};
  for (const auto& [name, sum] : sums) {
    const auto multipliers = multipliers_at_best(named(hock_schittkowski_problems(), name));
    ASSERT_TRUE(multipliers) << name;
    EXPECT_NEAR(multipliers->lpNorm<1>(), sum, 1e-10) << name;
  }
}

}  // namespace
}  // namespace ricochet::classic
