#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "problems/classic/hock_schittkowski.h"
#include "tests/problems/classic/claims.h"

/// Ours against other programs of the same problems.
namespace ricochet::classic {
namespace {

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

Row row_of(const std::string& line) {
  std::istringstream cells(line);
  std::array<std::string, 7> cell;
  for (std::string& text : cell) std::getline(cells, text, ',');
  const Eigen::Index equations = std::stoi(cell[1]);
  const Vector given = numbers(cell[6]);
  Vector constraints(given.size());
  constraints << given.tail(equations), -given.head(given.size() - equations);
  return {cell[0], equations, cell[3], numbers(cell[4]), std::stod(cell[5]), constraints};
}

const std::vector<Row>& rows() {
  static const std::vector<Row> all = [] {
    std::ifstream file(RICOCHET_SOURCE "/tests/problems/classic/hock_schittkowski_values.csv");
    std::vector<Row> result;
    for (std::string line; std::getline(file, line);) {
      if (line.starts_with("hs-")) result.push_back(row_of(line));
    }
    return result;
  }();
  return all;
}

TEST(HockSchittkowskiValues, AreThoseOfIndependentProgramsToTenDigits) {
  const std::vector<Problem> problems = hock_schittkowski_problems();
  std::size_t compared = 0;
  for (const Row& row : rows()) {
    SCOPED_TRACE(row.problem + " at its " + row.point + " point");
    const Problem problem = named(problems, row.problem);
    ASSERT_EQ(row.x.size(), problem.dimension());
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
}

TEST(HockSchittkowskiValues, AreThereForEveryProblemAtFivePoints) {
  std::set<std::pair<std::string, std::string>> seen;
  for (const Row& row : rows()) {
    EXPECT_TRUE(seen.emplace(row.problem, row.point).second) << row.problem << ' ' << row.point;
  }
  EXPECT_EQ(seen.size(), 5 * hock_schittkowski_problems().size());
}

TEST(HockSchittkowskiValues, StartWhereTheProblemsDo) {
  const std::vector<Problem> problems = hock_schittkowski_problems();
  for (const Row& row : rows()) {
    if (row.point != "start") continue;
    const Vector& start = named(problems, row.problem).start;
    EXPECT_LE((start - row.x).cwiseAbs().maxCoeff(), 1e-15) << row.problem;
  }
}

}  // namespace
}  // namespace ricochet::classic
