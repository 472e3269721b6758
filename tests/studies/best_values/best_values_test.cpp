#include "src/studies/best_values/best_values.h"

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/suite/machine.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/error.h"
#include "ricochet/machine.h"
#include "ricochet/run.h"
#include "solvers/library_solvers.h"
#include "src/core/instance.h"
#include "src/experiment/store.h"
#include "tests/support/files.h"
#include "tests/support/problems.h"
#include "tests/support/test.h"

namespace ricochet::studies::best_values {
namespace {

using namespace carrier_track;

/// (x - 1)^2 + (y - 2)^2, at most 1 in x + y: 2 at (0, 1); with derivatives.
Problem cut_bowl() {
  Problem problem = box_problem("cut-bowl", 2, -4, 4, 3, [](const Vector& x) {
    return (x - Vector{{1, 2}}).squaredNorm();
  });
  problem.constraints = 1;
  problem.evaluate = [bowl = problem.evaluate](const Vector& x) {
    return Values{bowl(x).objective, Vector::Constant(1, x.sum() - 1)};
  };
  problem.differentiate = [evaluate = problem.evaluate](const Vector& x) {
    return Derivatives{evaluate(x), 2 * (x - Vector{{1, 2}}), Matrix::Ones(1, 2)};
  };
  problem.penalty_weight = 10;
  return problem;
}

TEST(BestValues, MatchesByPartsAndByPatterns) {
  Problem first = falling_stairs(), second = falling_stairs();
  first.name = "profile-wear-8-C1";
  second.name = "profile-wear-8-C12";
  const auto matches = [&](const char* pattern) {
    return matching({first, second}, pattern).size();
  };
  EXPECT_EQ(matches(""), 2U);
  EXPECT_EQ(matches("wear"), 2U);
  EXPECT_EQ(matches("profile-*-C1"), 1U);
  EXPECT_THROW(matches("design"), InputError);
}

TEST(BestValues, AreProvenWhereACompleteScanLeavesNothingBetter) {
  Problem proven = falling_stairs(), open = two_stretches(), untold = falling_stairs();
  for (Problem* problem : {&proven, &open, &untold}) problem->best_known = -3;
  untold.best_known = {};
  untold.not_excluded = proven.not_excluded = [](double) { return std::vector<CoordinateRange>(); };
  open.not_excluded = [](double best) {
    return std::vector<CoordinateRange>{{-best, 3.25}, {3.5, 3.75}};
  };
  EXPECT_THAT(only(proofs({proven, open, untold, cut_bowl()}), {"proven", "left"}).rows,
              ElementsAre(ElementsAre(value_of(true), value_of("none")),
                          ElementsAre(value_of(false), value_of("3 to 3.25, 3.5 to 3.75"))));
}

class BestValueFile : public TemporaryFolder {
 protected:
  static BestValues read(const fs::path& from) { return parse_best_values(text_of(from), "file"); }
  BestKnown stairs() const { return read(file).of.at("stairs"); }

  Outcome find(const std::string& pattern = "") const {
    return find_best_values(problems, {pattern}, file);
  }

  const fs::path file = folder_ / "best.toml";
  const fs::path part = folder_ / "best.toml.part";
  std::vector<Problem> problems = {falling_stairs(), two_stretches()};
};

TEST_F(BestValueFile, HasTheBestValuesAndLeavesNothingElse) {
  EXPECT_THAT(find(), FieldsAre(2U, 2U, 2U, 0U));
  EXPECT_EQ(stairs().value, -3);
  EXPECT_EQ(read(file).machine, default_machine_hash());
  EXPECT_FALSE(fs::exists(part));
}

TEST_F(BestValueFile, GoesOnWhereItWasStopped) {
  find("stairs");
  fs::rename(file, part);  // as if it had been stopped then
  int evaluations = 0;
  problems[0].evaluate = [&, evaluate = problems[0].evaluate](const Vector& x) {
    ++evaluations;
    return evaluate(x);
  };
  EXPECT_EQ(find().finished, 2U);
  EXPECT_EQ(stairs().value, -3);
  EXPECT_LE(evaluations, 2) << "looked at, but not looked for again";
}

TEST_F(BestValueFile, KeepsWhatACallForOthersHasFinished) {
  find("stairs");
  fs::rename(file, part);
  find("stretches");
  EXPECT_EQ(read(part).of.count("stairs"), 1U);
  EXPECT_EQ(read(part).of.count("stretches"), 0U);
}

TEST_F(BestValueFile, LooksAgainForWhatWasChanged) {
  find();
  const std::string whole = text_of(file);
  fs::remove(file);
  std::string changed = whole;
  write_file(part, changed.replace(changed.find("value = -3.0"), 12, "value = -99.0"));
  find();
  EXPECT_EQ(text_of(file), whole);
}

TEST_F(BestValueFile, BeginsNothingWithoutTime) {
  Plan plan;
  plan.seconds = -1;
  EXPECT_EQ(find_best_values(problems, plan, file).finished, 0U);
  EXPECT_FALSE(fs::exists(file));
}

TEST_F(BestValueFile, NeverReplacesABetterValueByAWorseOne) {
  problems[0].scan_step = 0.3;  // misses the best stair
  problems[0].best_point = Vector::Constant(1, 2.003);
  problems[0].best_known = -3;
  problems[0].provenance = "by hand";
  EXPECT_EQ(find().improved, 1U);
  EXPECT_EQ(stairs().provenance, "by hand");
  problems[0] = falling_stairs();
  find();  // And once more from the file.
  EXPECT_EQ(stairs().provenance, "by hand");
}

/// A value is worth what it is worth today.
TEST_F(BestValueFile, ForgetsAValueThatDoesNotComeOutAgain) {
  problems[0].best_point = Vector::Constant(1, 3.0);
  problems[0].best_known = -100;
  problems[0].provenance = "of another interpretation";
  find();
  EXPECT_EQ(stairs().value, -3);
}

TEST_F(BestValueFile, IsNotWrittenForNothingNorOverWhatIsOfAnotherMachineOrNone) {
  EXPECT_THROW(find("nothing"), InputError);
  write_file(part, write_best_values({"sideways", {}}));
  EXPECT_THROW(find(), InputError);
  fs::remove(part);
  write_file(file, "no values");
  EXPECT_THROW(find(), InputError);
}

class StoredValues : public BestValueFile {
 protected:
  StoredValues() {
    problem.best_known = 5;  // not the best
    problem.best_point = Vector::Zero(2);
    problem.provenance = "by hand";
  }

  /// How many values are better in a store of one run on an instance, whose best point is, as
  /// stated, x.
  std::size_t taken(int number, const Vector& x) const {
    CampaignDescription description;
    description.problems = {{problem.name, "bowls", "", 2, 1, 0, 1e-6, 5, {}}};
    description.solvers = {{"guess", "1"}};
    const Problem moved = instance(problem, number);
    const Vector from = stated_point(problem, number, moved.lower);
    const Vector to = stated_point(problem, number, moved.upper);
    const Vector share = (x - from).cwiseQuotient(to - from);
    const Vector point = moved.lower + share.cwiseProduct(moved.upper - moved.lower);
    RunRecord record;
    record.problem = problem.name;
    record.solver = "guess";
    record.instance = number;
    record.seed = 7;
    record.budget.evaluations = 100;
    record.ledger.charged = 42;
    record.trace = {{42, 0, true_values_at(moved, point), point}};
    fs::remove(store);
    Store::create(store, description)
        .add({{problem.name, "original", "plain", "guess", 50}, number, 0}, record);
    return take_stored_values({problem}, store, file);
  }

  const fs::path store = folder_ / "runs.sqlite";
  Problem problem = cut_bowl();
};

TEST_F(StoredValues, AreTakenInTheProblemAsStatedIfTheyAreBetter) {
  const Vector x{{0.25, 0.5}};
  EXPECT_EQ(taken(3, x), 1U);
  const BestKnown best = read_if_there(file).of.at("cut-bowl");
  EXPECT_LT((best.point - x).norm(), 1e-12);
  EXPECT_NEAR(best.value, 0.75 * 0.75 + 1.5 * 1.5, 1e-12);
  EXPECT_EQ(best.provenance, "guess, seed 7, 42 of 100 evaluations");
  EXPECT_EQ(take_stored_values({problem}, store, file), 0U);
}

TEST_F(StoredValues, OfInfeasibleOrHardlyBetterPointsAreLeft) {
  EXPECT_EQ(taken(2, Vector{{1, 2}}), 0U) << "0, but infeasible";
  EXPECT_EQ(taken(2, Vector{{-2, -2}}), 0U) << "worse";
  EXPECT_EQ(taken(2, Vector::Constant(2, 1e-8)), 0U) << "within the tolerance: not worth a hash";
  EXPECT_FALSE(fs::exists(file));
  EXPECT_THROW(take_stored_values({problem}, folder_ / "no.sqlite", file), InputError);
}

TEST(Search, OfSeveralVariablesFindsTheConstrainedOptimumAgain) {
  const BestKnown best = best_of(cut_bowl(), Effort{200});
  EXPECT_NEAR(best.value, 2.0, 1e-6);
  EXPECT_NEAR(best.point[0], 0, 1e-3);
  EXPECT_LE(best.point.sum(), 1 + constraint_tolerance);
  EXPECT_THAT(best.provenance, HasSubstr("seed"));
  EXPECT_THAT(best_of(cut_bowl(), Effort{200}), FieldsAre(best.value, best.point, best.provenance));
}

TEST(Search, ScansOneVariableByTheStepOfItsProblem) {
  Problem problem = falling_stairs();
  EXPECT_THAT(best_of(problem, {}).provenance, HasSubstr("step 0.001"));
  problem.scan_step = 0.01;
  EXPECT_THAT(best_of(problem, {}).provenance, HasSubstr("step 0.01"));
}

/// Stairs up from the middle of the box, with a surrogate.
Problem steps() {
  Problem steps =
      box_problem("steps", 2, -4, 4, 3, [](const Vector& x) { return std::ceil(x.squaredNorm()); });
  steps.tolerance = 0.5;
  steps.smoothing = 0.3;
  return steps;
}

TEST(Search, EndsWhereTwoAgreeAndSaysSoAndImprovesOnTheSurrogateToo) {
  Problem problem = steps();
  std::set<double> smoothings;
  problem.smoothed = [&smoothings, smooth = problem](double smoothing) {
    smoothings.insert(smoothing);
    return smooth;
  };
  EXPECT_THAT(best_of(problem, Effort{200}).provenance,
              HasSubstr("; 2 of 2 searches of 400 evaluations"));
  EXPECT_TRUE(smoothings.contains(0.3));
}

TEST(Search, KeepsABestPointThatNoSearchFinds) {
  Problem needle = steps();
  const Vector x = Vector::Constant(2, 3.21);
  needle.evaluate = [x, others = needle.evaluate](const Vector& at) {
    return at == x ? Values{-9, {}} : others(at);
  };
  needle.best_point = x;
  needle.best_known = -9;
  needle.provenance = "by hand; 2 of 3 searches of 7 evaluations agree";
  EXPECT_THAT(best_of(needle, Effort{50, 1}),
              FieldsAre(-9, x, "by hand; 0 of 3 searches of 100 evaluations agree"));
}

/// What a loop over all multiples of the step finds: the fastest quiet speed, and how often a loud
/// speed is followed by a quiet one.
std::pair<double, int> look_everywhere(const Machine& machine, double step) {
  double fastest = 0;
  int returns = 0;
  const SpeedScan scan = scan_speeds(machine.scene, step, fastest_speed);
  for (std::size_t k = 0; k < scan.counts.size(); ++k) {
    if (scan.counts[k] > machine.quiet_limit) continue;
    fastest = scan.omega(k);
    if (k > 0 && scan.counts[k - 1] > machine.quiet_limit) ++returns;
  }
  return {fastest, returns};
}

TEST(HardSearch, DrawsTheSameMachineAgain) {
  const auto drawn = [](int draw) { return random_machine(default_machine(), "C9", draw); };
  const Machine machine = drawn(7);
  EXPECT_NO_THROW(check(machine.scene, "random"));
  EXPECT_EQ(write_scene(machine.scene), write_scene(drawn(7).scene));
  EXPECT_NE(write_scene(machine.scene), write_scene(drawn(8).scene));
  EXPECT_EQ(machine.quiet_limit, quiet_limit(quiet_count(machine.scene, Claim{}, ScanOptions{})));
}

/// The file is of these draws; std::pow may round its last digit otherwise elsewhere.
TEST(HardSearch, DrewTheMachinesOfTheFile) {
  for (const HardMachine& hard : hard_machines()) {
    SCOPED_TRACE(hard.machine.id);
    const Machine drawn = random_machine(found_hard_machines().constants, hard.around, hard.draw);
    const Scene& scene = hard.machine.scene;
    EXPECT_EQ(drawn.quiet_limit, hard.machine.quiet_limit);
    EXPECT_NEAR(drawn.scene.mass, scene.mass, 1e-12 * scene.mass);
    EXPECT_NEAR(drawn.scene.disturbance, scene.disturbance, 1e-10);
    EXPECT_NEAR(drawn.scene.phase, scene.phase, 1e-12);
  }
}

TEST(HardSearch, FoundTheFastestQuietSpeedBeyondLoudOnes) {
  constexpr double step = 1e-3;
  for (const HardMachine& hard : hard_machines()) {
    const auto [fastest, returns] = look_everywhere(hard.machine, step);
    EXPECT_LE(fastest, hard.best.point[0]) << hard.machine.id;
    EXPECT_GT(fastest, hard.best.point[0] - step) << hard.machine.id;
    EXPECT_GE(returns, 1) << hard.machine.id;
  }
}

TEST(HardSearch, KeepsWhatBisectionMissesFromBothEndsAndTheMiddle) {
  // Sixteen halvings, to less than a thirtieth of the tolerance, and no second start.
  const Budget budget{18};
  for (const HardMachine& hard : hard_machines()) {
    Problem problem = hard_top_speed_problem(hard);
    for (const double share : {0.0, 0.5, 1.0}) {
      problem.start = problem.lower + share * (problem.upper - problem.lower);
      const RunRecord record = run(problem, bisection(), budget, 0);
      ASSERT_TRUE(record.failure.empty()) << record.failure;
      EXPECT_FALSE(judge(record, problem, problem.tolerance).solved)
          << problem.name << " from " << share;
    }
  }
}

/// Every true objective again, on a grid as fine as that of the search; of one machine, since to
/// judge it takes ten seconds.
TEST(HardSearch, JudgesAMachineAsItsFileSays) {
  const HardMachine& hard = hard_machines().at(5);
  EXPECT_NEAR(look_everywhere(hard.machine, 1e-4).first, hard.best.point[0] - 0.5e-4, 0.5e-4);
  const auto again = judged_hard(hard.machine);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->best.value, hard.best.value);
  EXPECT_EQ(again->best.provenance, hard.best.provenance);
  EXPECT_EQ(again->hardness, hard.hardness);
  EXPECT_FALSE(judged_hard(all_machines()[0])) << "a machine of the paper";
}

}  // namespace
}  // namespace ricochet::studies::best_values
