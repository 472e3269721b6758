#include "src/studies/trials/trial_search.h"

#include <gtest/gtest.h>

#include "solvers/solvers.h"
#include "src/studies/trials/all_trials.h"

namespace ricochet::studies::trials {
namespace {

using namespace carrier_track;

/// Its misfit is made up: every count is 0 but at one value of its own constant.
Trial made_up_trial() {
  Trial trial;
  trial.name = "made-up";
  trial.freed = {Open::clearance, Open::phase};
  trial.own = {{"one", "", 1, 100, true, 10, "why"}, {"two", "", -1, 3, false, 0, "why"}};
  trial.counts = [](const Case&, const TrialConstants& constants, const Patience&) -> CountAt {
    return [own = constants.own](double) { return static_cast<int>(own[0]); };
  };
  return trial;
}

Solver solver_of(const char* name) {
  for (const Solver& solver : all_solvers()) {
    if (solver.name == name) return solver;
  }
  throw std::out_of_range(name);
}

TrialSearch brief_search() {
  return {solver_of("pagmo-cmaes-ipop"), solver_of("nlopt-sbplx"), 45, 1};
}

TEST(TrialSearch, MovesFreedAndOwnConstantsWithinTheirBounds) {
  const Problem problem = trial_problem(made_up_trial());
  ASSERT_EQ(problem.dimension(), 4);
  EXPECT_EQ(problem.variables[1].name, "phase");
  EXPECT_EQ(problem.variables[2].name, "one");
  EXPECT_DOUBLE_EQ(problem.start[2], 0.5) << "10 is in the middle of 1 to 100";
  EXPECT_DOUBLE_EQ(problem.start[3], 0.25);
  const TrialConstants low = constants_at(made_up_trial(), problem.lower);
  const TrialConstants high = constants_at(made_up_trial(), problem.upper);
  EXPECT_DOUBLE_EQ(low.base[static_cast<std::size_t>(Open::clearance)], 5e-5);
  EXPECT_DOUBLE_EQ(high.base[static_cast<std::size_t>(Open::clearance)], 1e-2);
  EXPECT_DOUBLE_EQ(low.own[0], 1);
  EXPECT_DOUBLE_EQ(high.own[1], 3);
  const TrialConstants start = constants_at(made_up_trial(), problem.start);
  EXPECT_NEAR(start.base[static_cast<std::size_t>(Open::pull)],
              start_of(made_up_trial()).base[static_cast<std::size_t>(Open::pull)], 0);
}

TEST(TrialSearch, FindsTheSameFromTheSameSeedAndIsNoWorseThanItsStart) {
  const Trial trial = made_up_trial();
  const TrialFit one = fit(trial, brief_search());
  const TrialFit two = fit(trial, brief_search());
  EXPECT_EQ(one.constants.own, two.constants.own);
  EXPECT_EQ(one.misfit, two.misfit);
  EXPECT_EQ(one.misfit, misfit_of(trial, one.constants));
  EXPECT_LT(one.misfit, misfit_of(trial, start_of(trial)));
}

TEST(TrialSearch, HasAKeyForEverythingThatDecides) {
  const std::string key = key_of(made_up_trial(), brief_search());
  EXPECT_EQ(key, key_of(made_up_trial(), brief_search()));
  TrialSearch search = brief_search();
  search.evaluations = 46;
  EXPECT_NE(key, key_of(made_up_trial(), search));
  search = brief_search();
  search.seed = 2;
  EXPECT_NE(key, key_of(made_up_trial(), search));
  search = brief_search();
  search.local = search.global;
  EXPECT_NE(key, key_of(made_up_trial(), search));
  Trial trial = made_up_trial();
  trial.freed.pop_back();
  EXPECT_NE(key, key_of(trial, brief_search()));
  trial = made_up_trial();
  trial.own[0].upper = 101;
  EXPECT_NE(key, key_of(trial, brief_search()));
}

}  // namespace
}  // namespace ricochet::studies::trials
