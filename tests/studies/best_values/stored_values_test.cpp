#include <gtest/gtest.h>

#include "ricochet/error.h"
#include "src/core/instance.h"
#include "src/experiment/store.h"
#include "src/studies/best_values/best_values.h"
#include "tests/support/files.h"
#include "tests/studies/best_values/some_problems.h"

namespace ricochet::studies::best_values {
namespace {

class StoredValues : public TemporaryFolder {
 protected:
  const std::filesystem::path store = folder_ / "runs.sqlite";
  const std::filesystem::path file = folder_ / "best.toml";

  /// A problem with a best value that is not the best.
  static Problem problem() {
    Problem bowl = cut_bowl();
    bowl.best_known = 5;
    bowl.best_point = Vector::Zero(2);
    bowl.provenance = "by hand";
    return bowl;
  }

  /// A store of one run on an instance, whose best point is, as stated, x.
  void keep(int number, const Vector& x) const {
    CampaignDescription description;
    description.problems = {{problem().name, "bowls", "", 2, 1, 0, 1e-6, 5, {}}};
    description.solvers = {{"guess", "1"}};
    const Problem moved = instance(problem(), number);
    const Vector from = stated_point(problem(), number, moved.lower);
    const Vector to = stated_point(problem(), number, moved.upper);
    const Vector share = (x - from).cwiseQuotient(to - from);
    const Vector point = moved.lower + share.cwiseProduct(moved.upper - moved.lower);
    RunRecord record;
    record.problem = problem().name;
    record.solver = "guess";
    record.instance = number;
    record.seed = 7;
    record.budget.evaluations = 100;
    record.ledger.charged = 42;
    record.trace = {{42, 0, true_values_at(moved, point), point}};
    RunKey key{{problem().name, "original", "plain", "guess", 50}, number, 0};
    Store::create(store, description).add(key, record);
  }
};

TEST_F(StoredValues, AreTakenInTheProblemAsStatedIfTheyAreBetter) {
  const Vector x = (Vector(2) << 0.25, 0.5).finished();
  keep(3, x);
  EXPECT_EQ(take_stored_values({problem()}, store, file), 1U);
  const BestKnown best = read_if_there(file).of.at("cut-bowl");
  EXPECT_LT((best.point - x).norm(), 1e-12);
  EXPECT_NEAR(best.value, 0.75 * 0.75 + 1.5 * 1.5, 1e-12);
  EXPECT_EQ(best.provenance, "guess, seed 7, 42 of 100 evaluations");
  EXPECT_EQ(take_stored_values({problem()}, store, file), 0U);
}

TEST_F(StoredValues, WithinTheToleranceAreNotWorthAnotherHash) {
  keep(2, Vector::Constant(2, 1e-8));
  EXPECT_EQ(take_stored_values({problem()}, store, file), 0U);
}

TEST_F(StoredValues, OfInfeasibleOrWorsePointsAreLeft) {
  keep(2, (Vector(2) << 1, 2).finished());  // 0, but infeasible
  EXPECT_EQ(take_stored_values({problem()}, store, file), 0U);
  EXPECT_FALSE(std::filesystem::exists(file));
  std::filesystem::remove(store);
  keep(2, (Vector(2) << -2, -2).finished());
  EXPECT_EQ(take_stored_values({problem()}, store, file), 0U);
}

TEST_F(StoredValues, RefuseAStoreThatIsNone) {
  EXPECT_THROW(take_stored_values({problem()}, folder_ / "no.sqlite", file), InputError);
}

}  // namespace
}  // namespace ricochet::studies::best_values
