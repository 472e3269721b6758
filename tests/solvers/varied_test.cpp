#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "problems/classic/classic.h"
#include "ricochet/error.h"
#include "ricochet/solver.h"
#include "solvers/adjustable_solver.h"
#include "solvers/fireworks/dynamic_fireworks.h"
#include "tests/solvers/fireworks/asked_points.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

using testing::HasSubstr;

/// Of every kind: with residuals, without constraints, with inequalities, with equalities.
const std::vector<Problem>& problems() {
  static const std::vector<Problem> chosen = [] {
    std::vector<Problem> all;
    for (const Family& family : classic::families()) {
      for (const Problem& problem : family.problems) {
        const std::string name = problem.name;
        for (const char* wanted :
             {"classic-rosenbrock-5", "classic-ackley-5", "hs-71", "hs-65", "least-squares-04"}) {
          if (name.starts_with(wanted)) all.push_back(problem);
        }
      }
    }
    all.push_back(disc());  // with second derivatives
    return all;
  }();
  return chosen;
}

/// What tells one run from another.
std::vector<double> trail(const Problem& problem, const Solver& solver,
                          std::int64_t evaluations = 600) {
  const RunRecord record = run(problem, solver, {evaluations}, 1);
  std::vector<double> trail = {static_cast<double>(record.ledger.charged),
                               static_cast<double>(record.ledger.values),
                               static_cast<double>(record.ledger.derivatives),
                               static_cast<double>(record.terminations.size())};
  for (const Improvement& step : record.trace) {
    trail.push_back(static_cast<double>(step.evaluations));
    trail.insert(trail.end(), step.x.begin(), step.x.end());
  }
  return trail;
}

Solver plain(const std::string& name) {
  for (const Solver& solver : all_solvers()) {
    if (solver.name == name) return solver;
  }
  throw std::logic_error(name);
}

/// Under its own name, which is part of the seed.
Solver with(const AdjustableSolver& solver, const std::string& option, const OptionValue& value) {
  return varied(solver.name, solver.name, {{option, value}});
}

/// Whether this build has it.
bool is_there(const std::string& solver) {
  const std::vector<AdjustableSolver> all = adjustable_solvers();
  return std::any_of(all.begin(), all.end(),
                     [&](const AdjustableSolver& each) { return each.name == solver; });
}

bool is_ipopt(const AdjustableSolver& solver) {
  return solver.name.starts_with("ipopt");
}

/// Whether any of these values makes any run another one.
bool changes_a_run(const AdjustableSolver& solver, const std::string& option,
                   const std::vector<OptionValue>& values) {
  // For some generations; the library's own CMA-ES starts again late.
  const std::int64_t long_enough = solver.name == "pagmo-cmaes-ipop" ? 30'000 : 3000;
  const Solver own = plain(solver.name);
  for (const Problem& problem : problems()) {
    if (!own.accepts(problem)) continue;
    const auto usual = trail(problem, own, long_enough);
    for (const OptionValue& value : values) {
      try {
        if (trail(problem, with(solver, option, value), long_enough) != usual) return true;
      } catch (const InputError&) {
        continue;  // it does not go with the others
      }
    }
  }
  return false;
}

/// Some that are allowed and cost little.
std::vector<OptionValue> values_for(const SolverOption& option) {
  if (!option.words.empty()) return {option.words.begin(), option.words.end()};
  std::vector<OptionValue> values;
  for (const double value :
       {option.range.least, option.range.most, std::sqrt(option.range.least * option.range.most),
        1.0, 2.0, 3.0, 20.0, 30.0, 0.5, 0.9, 0.3, 0.1, 0.01}) {
    if (option.allows(value) && std::abs(value) <= 100) values.push_back(value);
  }
  return values;
}

TEST(Varied, AsksForTheSameAsItsOwnWhereNothingIsGiven) {
  EXPECT_EQ(problems().size(), 6U);
  for (const AdjustableSolver& adjustable : adjustable_solvers()) {
    const Solver own = plain(adjustable.name);
    const Solver same = varied(own.name, own.name, {});
    EXPECT_EQ(same.version, own.version + ", " + own.name);
    EXPECT_EQ(same.stochastic, own.stochastic);
    bool any = false;
    for (const Problem& problem : problems()) {
      ASSERT_EQ(same.accepts(problem), own.accepts(problem)) << own.name;
      if (!own.accepts(problem)) continue;
      any = true;
      EXPECT_EQ(trail(problem, same), trail(problem, own)) << own.name << ' ' << problem.name;
    }
    EXPECT_TRUE(any) << own.name;
  }
}

TEST(Varied, TellsWhatIsUsual) {
  for (const AdjustableSolver& adjustable : adjustable_solvers()) {
    if (is_ipopt(adjustable)) continue;
    const Solver own = plain(adjustable.name);
    for (const SolverOption& option : adjustable.options) {
      std::size_t read = 0;
      double usual = 0;
      try {
        usual = std::stod(option.usual, &read);
      } catch (const std::invalid_argument&) {
        continue;  // it hangs on the problem
      }
      if (read != option.usual.size()) continue;
      EXPECT_TRUE(option.allows(usual)) << own.name << ' ' << option.name;
      for (const Problem& problem : problems()) {
        if (!own.accepts(problem)) continue;
        EXPECT_EQ(trail(problem, with(adjustable, option.name, usual)), trail(problem, own))
            << own.name << ' ' << option.name << ' ' << problem.name;
      }
    }
  }
}

TEST(Varied, MakesAnotherRunWithEveryOption) {
  for (const AdjustableSolver& adjustable : adjustable_solvers()) {
    if (is_ipopt(adjustable)) continue;
    for (const SolverOption& option : adjustable.options) {
      EXPECT_TRUE(changes_a_run(adjustable, option.name, values_for(option)))
          << adjustable.name << ' ' << option.name;
    }
  }
}

TEST(Varied, IsWhatItsOptionsSay) {
  fireworks::BareBonesFireworksOptions options;
  options.sparks = 17;
  options.steps.growth = 1.5;
  const Solver solver = varied("bbfwa", "mine", {{"sparks", 17.0}, {"growth", 1.5}});
  EXPECT_EQ(asked_points(sphere(3, 7), solver, 500),
            asked_points(sphere(3, 7), fireworks::bare_bones_fireworks("mine", options), 500));
  EXPECT_EQ(solver.name, "mine");
  EXPECT_THAT(solver.version, testing::EndsWith(", bbfwa growth 1.5 sparks 17"));
}

std::string complaint(const std::string& of, const GivenOptions& options) {
  try {
    varied(of, "mine", options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(Varied, RefusesWhatCannotBe) {
  EXPECT_THAT(complaint("bbfw", {}), HasSubstr("bbfw: no such solver has options; did you mean"));
  EXPECT_THAT(complaint("scan", {}), HasSubstr("no such solver has options"));
  EXPECT_THAT(complaint("bbfwa", {{"spark", 3.0}}),
              HasSubstr("spark: bbfwa has no such option; did you mean sparks?"));
  EXPECT_THAT(complaint("bbfwa", {{"amplitude", 3.0}}), HasSubstr("has no such option"));
  EXPECT_THAT(complaint("bbfwa", {{"sparks", 0.0}}),
              HasSubstr("sparks = 0: must be a whole number from 1 to 1000000"));
  EXPECT_THAT(complaint("bbfwa", {{"sparks", 1.5}}), HasSubstr("a whole number"));
  EXPECT_THAT(complaint("bbfwa", {{"sparks", "many"}}),
              HasSubstr("sparks = many: must be a whole number"));
  EXPECT_THAT(complaint("lotfwa", {{"guiding_share", 2.0}}), HasSubstr("a number from 0.001 to 1"));
  EXPECT_THAT(complaint("efwa", {{"sparks", 3.0}}), HasSubstr("fewest * sparks"));
}

TEST(Varied, LeavesOutAnEndThatIsNotAllowed) {
  if (!is_there("pagmo-cmaes")) GTEST_SKIP();
  EXPECT_THAT(complaint("pagmo-cmaes", {{"initial_step", 0.0}}),
              HasSubstr("must be a number from 0 to 1, but not 0"));
  EXPECT_EQ(complaint("pagmo-cmaes", {{"initial_step", 1.0}}), "nothing");
}

TEST(Varied, GivesIpoptItsOwnOptions) {
  if (!is_there("ipopt")) GTEST_SKIP();
  const GivenOptions changes[] = {{{"mu_strategy", "monotone"}},
                                  {{"nlp_scaling_method", "none"}},
                                  {{"limited_memory_max_history", 1.0}},
                                  {{"max_iter", 2.0}}};
  const Problem& rosenbrock = problems().front();
  for (const GivenOptions& given : changes) {
    const std::string name = given.begin()->first;
    EXPECT_NE(trail(rosenbrock, varied("ipopt", "ipopt", given)), trail(rosenbrock, plain("ipopt")))
        << name;
  }
  // ipopt-tuned is Ipopt with three options.
  Solver tuned = varied(
      "ipopt", "ipopt-tuned",
      {{"mu_strategy", "monotone"}, {"mu_init", 1e-3}, {"limited_memory_max_history", 20.0}});
  for (const Problem& problem : problems()) {
    EXPECT_EQ(trail(problem, tuned), trail(problem, plain("ipopt-tuned"))) << problem.name;
  }
}

TEST(Varied, RefusesWhatIpoptWould) {
  if (!is_there("ipopt")) GTEST_SKIP();
  EXPECT_THAT(complaint("ipopt", {{"mu_stratgy", "adaptive"}}),
              HasSubstr("mu_stratgy: ipopt has no such option; did you mean mu_strategy"));
  EXPECT_THAT(complaint("ipopt", {{"mu_strategy", "bold"}}),
              HasSubstr("mu_strategy = bold: must be \"monotone\", \"adaptive\""));
  EXPECT_THAT(complaint("ipopt", {{"mu_strategy", 3.0}}), HasSubstr("must be \"monotone\""));
  EXPECT_THAT(complaint("ipopt", {{"mu_init", 0.0}}), HasSubstr("but not 0"));
  EXPECT_THAT(complaint("ipopt", {{"max_iter", 2.5}}), HasSubstr("a whole number from 0"));
  for (const char* kept : {"hessian_approximation", "output_file", "max_cpu_time"}) {
    EXPECT_THAT(complaint("ipopt", {{kept, "exact"}}), HasSubstr("no such option")) << kept;
  }
  EXPECT_GT(options_of("ipopt").size(), 200U);
}

TEST(Varied, RefusesWhatThisIpoptWasBuiltWithout) {
  if (!is_there("ipopt")) GTEST_SKIP();
  for (const char* solver : {"ipopt", "ipopt-exact", "ipopt-tuned"}) {
    int usable = 0;
    for (const SolverOption& option : options_of(solver)) {
      if (option.name != "linear_solver" && option.name != "linear_system_scaling" &&
          option.name != "nlp_scaling_method") {
        continue;
      }
      for (const std::string& word : option.words) {
        const std::string said = complaint(solver, {{option.name, word}, {"max_iter", 100.0}});
        if (said == "nothing") {
          const RunRecord record =
              run(disc(), varied(solver, "mine", {{option.name, word}}), {1000}, 1);
          EXPECT_NE(record.terminations.back().reason, "failure") << option.name << word;
          ++usable;
        } else {
          EXPECT_EQ(said, option.name + " = " + word + ": this build of Ipopt cannot use it");
        }
      }
    }
    EXPECT_GE(usable, 3) << solver;
  }
}

}  // namespace
}  // namespace ricochet
