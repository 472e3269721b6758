#include <gtest/gtest.h>

#include "ricochet/solver.h"
#include "src/analysis/comparison/solver_pages.h"

namespace ricochet::studies::comparison {
namespace {

TEST(SolverFacts, HaveTheSettingsOfEverySolverOfTheSuite) {
  for (const Solver& solver : all_solvers()) {
    EXPECT_TRUE(settings_of(solver.name).has_value()) << solver.name;
  }
  for (const MissingSolver& missing : missing_solvers()) {
    EXPECT_TRUE(settings_of(missing.solver).has_value()) << missing.solver;
  }
}

TEST(SolverFacts, AreThoseOfTheSolverItselfAndNoneOfAUsers) {
  EXPECT_EQ(settings_of("ipopt-tuned")->from, "tuned to this suite");
  EXPECT_EQ(settings_of("ipopt")->from, "Ipopt");
  EXPECT_FALSE(settings_of("hill-climber").has_value());
}

// Whoever reads a name must know that the solver was tuned on what it is compared on.
TEST(SolverFacts, SayOfEverySolverThatWasTunedToTheSuite) {
  for (const Solver& solver : all_solvers()) {
    const SolverSettings settings = settings_of(solver.name).value();
    const bool says = settings.from.find("tuned to this suite") != std::string::npos ||
                      settings.from.find("did best here") != std::string::npos ||
                      solver.name.ends_with("-tuned");
    EXPECT_TRUE(settings.tuned || !says) << solver.name;
    EXPECT_EQ(tuned_mark(solver.name).empty(), !settings.tuned || solver.name.ends_with("-tuned"))
        << solver.name;
  }
  EXPECT_EQ(tuned_mark("continuation-nlopt-slsqp"), " (tuned to this suite)");
  EXPECT_EQ(tuned_mark("mads"), "");
  EXPECT_EQ(tuned_mark("ipopt"), "");
}

TEST(SolverFacts, HaveAKindOfEverySolverOfTheSuite) {
  for (const Solver& solver : all_solvers())
    EXPECT_NE(kind_of(solver.name), "other") << solver.name;
  EXPECT_EQ(kind_of("fireworks-authors"), "fireworks");
  EXPECT_EQ(kind_of("nlopt-auglag-bobyqa"), "models");
  EXPECT_EQ(kind_of("nlopt-auglag-lbfgs"), "derivatives");
  EXPECT_EQ(kind_of("hill-climber"), "other");
}

TEST(SolverFacts, SayHowOldIpoptIs) {
  EXPECT_NE(library_note("Ipopt 3.11.9").find("2014"), std::string::npos);
  EXPECT_EQ(library_note("Ipopt 3.14.0"), "");
  EXPECT_EQ(library_note("NLopt 2.7.1"), "");
}

}  // namespace
}  // namespace ricochet::studies::comparison
