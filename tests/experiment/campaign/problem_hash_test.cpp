#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <set>

#include "src/experiment/planned_runs.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet {
namespace {

TEST(ProblemHash, DependsOnAllThatAScoreRestsOn) {
  const std::function<void(Problem&)> changes[] = {
      [](Problem&) {},
      [](Problem& q) { q.name = "another"; },
      [](Problem& q) { q.upper[0] = std::nextafter(1.0, 2.0); },
      [](Problem& q) { q.start[0] = 0.8; },
      [](Problem& q) { q.tolerance = 1e-5; },
      [](Problem& q) { q.penalty_weight = 2; },
      [](Problem& q) { q.smoothed = [q](double) { return q; }; },
      [](Problem& q) { q.rotates = true; },
      [](Problem& q) { q.best_known = std::numeric_limits<double>::min(); },
      [](Problem& q) { q.best_point = Vector::Constant(2, 0.25); },
      [](Problem& q) {
        q.evaluate = [](const Vector& x) { return Values{x.squaredNorm(), Vector()}; };
      },
      [](Problem& q) {
        q.true_values = [](const Vector&) -> TrueValues { throw std::runtime_error("none"); };
      }};
  std::set<std::string> hashes;
  for (const auto& change : changes) {
    Problem problem = bowl("bowl", 2);
    change(problem);
    const std::string hash = problem_hash(problem);
    EXPECT_EQ(hash.size(), 16U);
    EXPECT_EQ(problem_hash(problem), hash);
    hashes.insert(hash);
  }
  EXPECT_EQ(hashes.size(), std::size(changes));
}

}  // namespace
}  // namespace ricochet
