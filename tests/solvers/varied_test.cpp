#include <fmt/ranges.h>

#include "solvers/adjustable_solver.h"
#include "solvers/fireworks/dynamic_fireworks.h"
#include "tests/solvers/solve.h"

namespace ricochet {
namespace {

struct SomeOptions {
  int points = 20;
  double share = 0.125;
  std::optional<int> population = {};
};

template <class Visit, IsOf<SomeOptions>... O>
void visit_fields(const Visit& visit, O&... o) {
  visit(whole_option("points", 5), o.points...);
  Field share = real_option("share", 0, 0.5);
  share.range.without_least = true;
  visit(share, o.share...);
  visit(whole_option("population", 2, 10, "as many as variables"), o.population...);
}

TEST(SolverOption, AllowsWhatItsRangeOrItsWordsSay) {
  const std::vector<SolverOption> options = options_in(SomeOptions());
  ASSERT_EQ(options.size(), 3U);
  const SolverOption words{.name = "strategy", .usual = "mild", .words = {"mild", "bold"}};
  const SolverOption text{.name = "strategy", .usual = "mild", .words = {"*"}};
  using Values = std::vector<OptionValue>;
  const struct {
    SolverOption option;
    const char *name_and_usual, *allowed;
    Values good, bad;
  } cases[] = {
      {options[0],
       "points, 20",
       "a whole number from 5 to 1000000",
       {5.0, 6.0, 1e6},
       {4.0, 5.5, 1e6 + 1, "6"}},
      {options[1], "share, 0.125", "a number from 0 to 0.5, but not 0", {0.5, 0.3}, {0.0}},
      {options[2], "population, as many as variables", "a whole number from 2 to 10", {2.0}, {1.0}},
      {words, "strategy, mild", "\"mild\", \"bold\"", {"bold"}, {"rash", 0.0}},
      {text, "strategy, mild", "a text", {"rash"}, {}}};
  for (const auto& [option, name_and_usual, allowed, good, bad] : cases) {
    SCOPED_TRACE(name_and_usual);
    EXPECT_EQ(option.name + ", " + option.usual, name_and_usual);
    EXPECT_EQ(option.allowed(), allowed);
    for (const OptionValue& value : good) EXPECT_TRUE(option.allows(value));
    for (const OptionValue& value : bad) EXPECT_FALSE(option.allows(value));
  }
}

/// Of every kind: with residuals, without constraints, with inequalities, with equalities, with
/// second derivatives.
const std::vector<Problem>& problems_of_every_kind() {
  static const std::vector<Problem> chosen = {
      suite_problem("classic-rosenbrock-5"),
      suite_problem("classic-ackley-5"),
      suite_problem("hs-71"),
      suite_problem("hs-65"),
      suite_problem("least-squares-04-linear-rank-1-7x35-far"),
      disc()};
  return chosen;
}

/// What tells one run from another.
std::string trail(const Problem& problem, const Solver& solver, std::int64_t evaluations = 600) {
  const RunRecord record = run(problem, solver, {evaluations}, 1);
  std::string trail = fmt::format("{} {} {} {}", record.ledger.charged, record.ledger.values,
                                  record.ledger.derivatives, record.terminations.size());
  for (const Improvement& step : record.trace) {
    trail += fmt::format("\n{} {}", step.evaluations, fmt::join(step.x.begin(), step.x.end(), " "));
  }
  return trail;
}

/// Expects the same runs of both on all problems; at least on one.
void expect_same_runs(const Solver& solver, const Solver& other) {
  int compared = 0;
  for (const Problem& problem : problems_of_every_kind()) {
    ASSERT_EQ(solver.accepts(problem), other.accepts(problem)) << other.name;
    if (!solver.accepts(problem)) continue;
    ++compared;
    EXPECT_EQ(trail(problem, solver), trail(problem, other)) << other.name << ' ' << problem.name;
  }
  EXPECT_GT(compared, 0) << other.name;
}

/// Under its own name, which is part of the seed.
Solver with_option(const AdjustableSolver& solver, const std::string& option,
                   const OptionValue& value) {
  return varied(solver.name, solver.name, {{option, value}});
}

/// But those of Ipopt, which has hundreds of options.
std::vector<AdjustableSolver> adjustable_but_ipopt() {
  std::vector<AdjustableSolver> solvers = adjustable_solvers();
  std::erase_if(solvers, [](const auto& solver) { return solver.name.starts_with("ipopt"); });
  return solvers;
}

/// Whether any of these values makes any run another one.
bool changes_a_run(const AdjustableSolver& solver, const std::string& option,
                   const std::vector<OptionValue>& values) {
  // For some generations; the library's own CMA-ES starts again late.
  const std::int64_t long_enough = solver.name == "pagmo-cmaes-ipop" ? 30'000 : 3000;
  const Solver own = solver_named(solver.name);
  for (const Problem& problem : problems_of_every_kind()) {
    if (!own.accepts(problem)) continue;
    const std::string usual = trail(problem, own, long_enough);
    for (const OptionValue& value : values) {
      try {
        if (trail(problem, with_option(solver, option, value), long_enough) != usual) return true;
      } catch (const InputError&) {  // it does not go with the others
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
  for (const AdjustableSolver& adjustable : adjustable_solvers()) {
    const Solver own = solver_named(adjustable.name);
    const Solver same = varied(own.name, own.name, {});
    EXPECT_EQ(same.version, own.version + ", " + own.name);
    EXPECT_EQ(same.stochastic, own.stochastic);
    expect_same_runs(same, own);
  }
}

TEST(Varied, TellsWhatIsUsual) {
  for (const AdjustableSolver& adjustable : adjustable_but_ipopt()) {
    for (const SolverOption& option : adjustable.options) {
      char* end = nullptr;
      const double usual = std::strtod(option.usual.c_str(), &end);
      if (*end != '\0') continue;  // it hangs on the problem
      EXPECT_TRUE(option.allows(usual)) << adjustable.name << ' ' << option.name;
      SCOPED_TRACE(option.name);
      expect_same_runs(with_option(adjustable, option.name, usual), solver_named(adjustable.name));
    }
  }
}

TEST(Varied, MakesAnotherRunWithEveryOption) {
  for (const AdjustableSolver& adjustable : adjustable_but_ipopt()) {
    for (const SolverOption& option : adjustable.options) {
      EXPECT_TRUE(changes_a_run(adjustable, option.name, values_for(option)))
          << adjustable.name << ' ' << option.name;
    }
  }
}

TEST(Varied, IsWhatItsOptionsSay) {
  const Solver solver = varied("bbfwa", "mine", {{"sparks", 17.0}, {"growth", 1.5}});
  const Solver same =
      fireworks::bare_bones_fireworks("mine", {.sparks = 17, .steps = {.growth = 1.5}});
  EXPECT_EQ(asked_points(sphere(3, 7), solver, 500), asked_points(sphere(3, 7), same, 500));
  EXPECT_EQ(solver.name, "mine");
  EXPECT_THAT(solver.version, EndsWith(", bbfwa growth 1.5 sparks 17"));
}

std::string complaint(const std::string& of, const GivenOptions& options) {
  return complaint_of([&] { return varied(of, "mine", options); });
}

TEST(Varied, RefusesWhatCannotBe) {
  const struct {
    const char* of;
    GivenOptions options;
    const char* message;
  } refused[] = {
      {"bbfw", {}, "bbfw: no such solver has options; did you mean"},
      {"scan", {}, "no such solver has options"},
      {"bbfwa", {{"spark", 3.0}}, "spark: bbfwa has no such option; did you mean sparks?"},
      {"bbfwa", {{"amplitude", 3.0}}, "has no such option"},
      {"bbfwa", {{"sparks", 0.0}}, "sparks = 0: must be a whole number from 1 to 1000000"},
      {"bbfwa", {{"sparks", 1.5}}, "a whole number"},
      {"bbfwa", {{"sparks", "many"}}, "sparks = many: must be a whole number"},
      {"lotfwa", {{"guiding_share", 2.0}}, "a number from 0.001 to 1"},
      {"efwa", {{"sparks", 3.0}}, "fewest * sparks"},
      {"pagmo-cmaes", {{"initial_step", 0.0}}, "must be a number from 0 to 1, but not 0"},
      {"pagmo-cmaes", {{"initial_step", 1.0}}, "accepted"},
      {"ipopt", {{"mu_stratgy", "bold"}}, "mu_stratgy: ipopt has no such option; did you mean mu"},
      {"ipopt", {{"mu_strategy", "bold"}}, "mu_strategy = bold: must be \"monotone\", \"ada"},
      {"ipopt", {{"mu_strategy", 3.0}}, "must be \"monotone\""},
      {"ipopt", {{"mu_init", 0.0}}, "but not 0"},
      {"ipopt", {{"max_iter", 2.5}}, "a whole number from 0"},
      // These are kept.
      {"ipopt", {{"hessian_approximation", "exact"}}, "no such option"},
      {"ipopt", {{"output_file", "exact"}}, "no such option"},
      {"ipopt", {{"max_cpu_time", "exact"}}, "no such option"}};
  for (const auto& [of, options, message] : refused) {
    EXPECT_THAT(complaint(of, options), HasSubstr(message)) << of;
  }
}

TEST(Varied, GivesIpoptItsOwnOptions) {
  EXPECT_GT(options_of("ipopt").size(), 200U);
  const Problem& rosenbrock = problems_of_every_kind().front();
  const std::string usual = trail(rosenbrock, solver_named("ipopt"));
  for (const GivenOptions& given : {GivenOptions{{"mu_strategy", "monotone"}},
                                    {{"nlp_scaling_method", "none"}},
                                    {{"limited_memory_max_history", 1.0}},
                                    {{"max_iter", 2.0}}}) {
    EXPECT_NE(trail(rosenbrock, varied("ipopt", "ipopt", given)), usual) << given.begin()->first;
  }
  // ipopt-tuned is Ipopt with three options.
  expect_same_runs(
      varied(
          "ipopt", "ipopt-tuned",
          {{"mu_strategy", "monotone"}, {"mu_init", 1e-3}, {"limited_memory_max_history", 20.0}}),
      solver_named("ipopt-tuned"));
}

TEST(Varied, RefusesWhatThisIpoptWasBuiltWithout) {
  const std::set<std::string> built_in = {"linear_solver", "linear_system_scaling",
                                          "nlp_scaling_method"};
  for (const char* solver : {"ipopt", "ipopt-exact", "ipopt-tuned"}) {
    int usable = 0;
    for (const SolverOption& option : options_of(solver)) {
      if (!built_in.contains(option.name)) continue;
      for (const std::string& word : option.words) {
        const std::string said = complaint(solver, {{option.name, word}, {"max_iter", 100.0}});
        if (said != "accepted") {
          EXPECT_EQ(said, option.name + " = " + word + ": this build of Ipopt cannot use it");
          continue;
        }
        ++usable;
        const Solver mine = varied(solver, "mine", {{option.name, word}});
        EXPECT_NE(reasons_of(run(disc(), mine, {1000}, 1)).back(), "failure")
            << option.name << word;
      }
    }
    EXPECT_GE(usable, 3) << solver;
  }
}

}  // namespace
}  // namespace ricochet
