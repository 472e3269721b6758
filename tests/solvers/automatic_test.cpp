#include "solvers/automatic.h"

#include "tests/solvers/solve.h"

namespace ricochet {
namespace {

/// What a problem may declare, over three variables.
struct Facts {
  bool derivatives = false, residuals = false, jumps = false, surrogate = false;
  int inequalities = 0, equalities = 0;
  std::int64_t gradient_cost = 3;
  Eigen::Index variables = 3;
};

Problem with(const Facts& facts) {
  Problem problem = sphere(facts.variables, 0.5);
  if (!facts.derivatives) problem.differentiate = nullptr;
  problem.lagrangian_hessian = nullptr;
  if (!facts.residuals) problem.residuals = nullptr;
  problem.jumps = facts.jumps;
  problem.equalities = facts.equalities;
  problem.constraints = facts.equalities + facts.inequalities;
  if (facts.surrogate) problem = with_idle_knob(problem);
  return problem;
}

std::string chosen(const Facts& facts, const std::vector<Solver>& solvers) {
  const Problem problem = with(facts);
  Budget budget{300};
  budget.gradient_price = facts.gradient_cost;
  const auto choice = choice_of(Evaluator(problem, budget), solvers);
  return choice ? choice->solver : "";
}

/// One that takes all, of each of these names.
std::vector<Solver> made_up(const std::vector<std::string>& names) {
  std::vector<Solver> solvers;
  for (const std::string& name : names) {
    solvers.emplace_back().name = name;
    solvers.back().capabilities.constraints = Capabilities::Constraints::all;
  }
  return solvers;
}

TEST(Auto, ChoosesByWhatIsDeclared) {
  std::vector<std::string> names;
  for (const RuleLine& line : rule_of_auto()) {
    names.insert(names.end(), line.solvers.begin(), line.solvers.end());
  }
  const std::vector<Solver> all = made_up(names);
  EXPECT_EQ(chosen({.variables = 1}, all), "mads-tuned");
  EXPECT_EQ(chosen({.derivatives = true, .variables = 1}, all), "mads-tuned");
  EXPECT_EQ(chosen({.jumps = true}, all), "pagmo-cmaes-ipop");
  EXPECT_EQ(chosen({.jumps = true, .inequalities = 1}, all), "mads-tuned");
  const Facts surrogate = {.jumps = true, .surrogate = true, .gradient_cost = 2};
  EXPECT_EQ(chosen(surrogate, all), "continuation-nlopt-slsqp");
  EXPECT_EQ(chosen({.jumps = true, .surrogate = true, .gradient_cost = 3}, all),
            "pagmo-cmaes-ipop");
  EXPECT_EQ(chosen({.residuals = true}, all), "tao-pounders");
  EXPECT_EQ(chosen({.derivatives = true, .residuals = true}, all), "tao-pounders");
  EXPECT_EQ(chosen({.residuals = true, .inequalities = 1}, all), "nlopt-cobyla");
  EXPECT_EQ(chosen({.derivatives = true, .equalities = 2}, all), "scipy-slsqp");
  EXPECT_EQ(chosen({.equalities = 1}, all), "nlopt-cobyla");
  EXPECT_EQ(chosen({.inequalities = 1}, all), "nlopt-cobyla");
  EXPECT_EQ(chosen({}, all), "nlopt-mlsl-bobyqa");
}

TEST(Auto, TakesThoseThatTheBuildHas) {
  EXPECT_EQ(chosen({.residuals = true}, made_up({"ceres-trust-region"})), "ceres-trust-region");
  EXPECT_EQ(chosen({.derivatives = true}, made_up({"ipopt", "nlopt-slsqp"})), "nlopt-slsqp");
  // A line of which the build has no solver is passed over.
  EXPECT_EQ(chosen({.derivatives = true}, made_up({"nlopt-mlsl-bobyqa"})), "nlopt-mlsl-bobyqa");
  EXPECT_EQ(chosen({}, made_up({"another"})), "");
  std::vector<Solver> bounded = made_up({"nlopt-mlsl-bobyqa"});
  bounded[0].capabilities.constraints = Capabilities::Constraints::none;
  EXPECT_EQ(chosen({.inequalities = 1}, bounded), "");
}

TEST(Auto, RunsWhatItChose) {
  const std::vector<Solver> all = all_solvers();
  const auto named = [&](const std::string& name) {
    return *std::find_if(all.begin(), all.end(), [&](const Solver& s) { return s.name == name; });
  };
  for (const Facts& facts : {Facts{}, Facts{.derivatives = true}, Facts{.variables = 1}}) {
    const Problem problem = with(facts);
    const auto choice = choice_of(Evaluator(problem, {200}), all);
    ASSERT_TRUE(choice);
    const Solved own = solved(problem, named("auto"), 200);
    const Solved direct = solved(problem, named(choice->solver), 200);
    EXPECT_EQ(own.reason, choice->solver + " (" + choice->line->name + "): " + direct.reason);
    ASSERT_TRUE(own.best && direct.best);
    EXPECT_EQ(own.best->x, direct.best->x);
    EXPECT_EQ(own.best->evaluations, direct.best->evaluations);
    EXPECT_EQ(own.ledger.charged, direct.ledger.charged);
  }
}

TEST(Auto, NamesOnlySolversOfTheSuite) {
  std::vector<std::string> names;
  for (const Solver& solver : all_solvers()) names.push_back(solver.name);
  for (const RuleLine& line : rule_of_auto()) {
    EXPECT_THAT(names, testing::IsSupersetOf(line.solvers)) << line.name;
  }
  EXPECT_THAT(rule_of_auto().back().solvers, Not(IsEmpty()));
}

}  // namespace
}  // namespace ricochet
