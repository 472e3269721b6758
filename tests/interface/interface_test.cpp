// The problems of libricochet.so, from outside, against those that it is made of.

#include <malloc.h>

#include "ricochet/random.h"
#include "src/core/instance.h"
#include "src/core/seen_problem.h"
#include "src/studies/suite/suite.h"
#include "tests/interface/opened.h"
#include "tests/support/problems.h"
#include "tests/support/test.h"

namespace ricochet::interface {
namespace {

constexpr const char* least_squares = "least-squares-01-linear-full-rank-9x45";

/// The problems that the library is made of.
const std::vector<Problem>& problems() {
  static const std::vector<Problem> all = every_problem(suite_families());
  return all;
}

const Problem& problem_named(const std::string& name) {
  const auto found = std::ranges::find(problems(), name, &Problem::name);
  if (found == problems().end()) throw std::out_of_range(name);
  return *found;
}

void expect_refusal(const Opened& opened, const std::string& reason) {
  EXPECT_FALSE(opened);
  expect_reason(reason);
}

void expect_same_description(ricochet_problem* p, const Problem& problem) {
  const auto expected = std::tuple(problem.dimension(), problem.constraints, problem.equalities,
                                   problem.differentiate ? 1 : 0, problem.residuals ? 1 : 0);
  ASSERT_EQ(
      std::tuple(p->dimension, p->constraints, p->equalities, p->has_derivatives, p->has_residuals),
      expected);
  EXPECT_EQ(std::tuple(ricochet_dimension(p), ricochet_constraints(p), ricochet_equalities(p),
                       ricochet_has_derivatives(p), ricochet_has_residuals(p)),
            expected);
  for (const char* name : {p->name, ricochet_name(p)}) EXPECT_EQ(name, problem.name);
  const Eigen::Index n = problem.dimension();
  Vector lower(n), upper(n), start(n);
  EXPECT_EQ(ricochet_bounds(p, lower.data(), upper.data()) + ricochet_start(p, start.data()), 0);
  EXPECT_EQ(ricochet_bounds(p, nullptr, nullptr), 0);
  const auto expected_box = std::tie(problem.lower, problem.upper, problem.start);
  EXPECT_EQ(std::tie(lower, upper, start), expected_box);
  using View = Eigen::Map<const Vector>;
  EXPECT_EQ(std::tuple(View(p->lower, n), View(p->upper, n), View(p->start, n)), expected_box);
  const double best_known = ricochet_best_known(p);
  EXPECT_EQ(std::isnan(best_known) ? std::nullopt : std::optional(best_known), problem.best_known);
  EXPECT_EQ(ricochet_tolerance(p), problem.tolerance);
  EXPECT_EQ(ricochet_unit(p), problem.unit);
  const std::vector<Variable> unnamed(static_cast<std::size_t>(n));
  std::int32_t index = 0;
  for (const Variable& each : problem.variables.empty() ? unnamed : problem.variables) {
    EXPECT_EQ(ricochet_variable_name(p, index), each.name);
    EXPECT_EQ(ricochet_variable_unit(p, index++), each.unit);
  }
  EXPECT_EQ(index, n);
}

/// The two are the same in every bit: described, and at a few points, by the functions of the
/// structure and by those of the library.
void expect_same(const Opened& opened, const Problem& problem) {
  ASSERT_TRUE(opened) << ricochet_error();
  ricochet_problem* const p = opened.get();
  ASSERT_NO_FATAL_FAILURE(expect_same_description(p, problem));
  Random random(1);
  for (const bool of_library : {false, true, false, true}) {
    const auto values = of_library ? ricochet_values : p->values;
    const auto derivatives = of_library ? ricochet_derivatives : p->derivatives;
    const auto residual_count = of_library ? ricochet_residual_count : p->residual_count;
    const auto residuals = of_library ? ricochet_residuals : p->residuals;
    const Vector x = of_library ? uniform_point(problem, random) : problem.start;
    double f = 0;
    Vector c(problem.constraints), g(x.size());
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows(c.size(), x.size());
    ASSERT_EQ(values(p, x.data(), &f, c.data()), 0) << ricochet_error();
    const Values expected = problem.evaluate(x);
    EXPECT_EQ(std::tie(f, c), std::tie(expected.objective, expected.constraints));
    if (problem.differentiate) {
      const Derivatives d = problem.differentiate(x);
      ASSERT_EQ(derivatives(p, x.data(), &f, c.data(), g.data(), rows.data()), 0);
      EXPECT_EQ(std::tie(f, c, g), std::tie(d.values.objective, d.values.constraints, d.gradient));
      EXPECT_EQ(Matrix(rows), d.jacobian);
    }
    if (problem.residuals) {
      const Residuals r = problem.residuals(x);
      ASSERT_EQ(residual_count(p, x.data()), r.values.size());
      c.resize(r.values.size());
      rows.resize(c.size(), x.size());
      ASSERT_EQ(residuals(p, x.data(), c.data(), rows.data()), 0);
      EXPECT_EQ(c, r.values);
      EXPECT_EQ(Matrix(rows), r.jacobian);
    }
    const std::int64_t remaining = p->remaining(p);
    double violation = -1;
    EXPECT_EQ(ricochet_judge(p, x.data(), &f, &violation), 0);
    EXPECT_THAT(true_values_at(problem, x), FieldsAre(f, violation));
    EXPECT_EQ(ricochet_remaining(p), remaining) << "to judge costs nothing";
  }
}

TEST(Interface, OpensEveryProblem) {
  int index = 0;
  for (const Problem& problem : problems()) {
    SCOPED_TRACE(problem.name);
    ASSERT_EQ(ricochet_problem_name(index++), problem.name);
    // Of calibration a point takes a second; what may hang or crash does so here.
    if (problem.cost > 1000 || problem.hazardous) continue;
    expect_same(open(problem.name), problem);
  }
  EXPECT_EQ(ricochet_problem_name(index), nullptr);
  EXPECT_EQ(ricochet_problem_name(-1), nullptr);
}

TEST(Interface, OpensEveryFormulationAndInstance) {
  for (const char* const name : {"count-C4", "top-speed-C1", "hs-71", "profile-count-8-C4"}) {
    const Problem& problem = problem_named(name);
    for (const Formulation& formulation : problem.formulations()) {
      for (const int number : {0, 1, 7}) {
        SCOPED_TRACE(problem.name_of(formulation));
        expect_same(open(name, problem.name_of(formulation), number),
                    instance(problem.formulated(formulation), number));
      }
    }
  }
}

TEST(Interface, ChargesOnceWhoAsksForPartsOfOnePoint) {
  const Opened of_values = open("hs-71", "", 0, 100),
               of_residuals = open(least_squares, "", 0, 100);
  ricochet_problem* const p = of_values.get();
  const Vector x = Vector::Constant(4, 1.5), y = Vector::Ones(9), z = Vector::Zero(9);
  std::array<double, 45 * 9> told{};
  EXPECT_EQ(p->values(p, x.data(), told.data(), nullptr), 0);
  EXPECT_EQ(p->values(p, x.data(), nullptr, told.data()), 0);
  EXPECT_EQ(p->remaining(p), 99);
  EXPECT_EQ(p->derivatives(p, x.data(), nullptr, nullptr, told.data(), nullptr), 0);
  EXPECT_EQ(p->derivatives(p, x.data(), nullptr, nullptr, nullptr, told.data()), 0);
  EXPECT_EQ(p->remaining(p), 95) << "the values were known";
  EXPECT_EQ(p->values(p, x.data(), told.data(), nullptr), 0);
  EXPECT_EQ(p->remaining(p), 94) << "asked for the second time";
  ricochet_problem* const q = of_residuals.get();
  EXPECT_EQ(q->residual_count(q, y.data()), 45);
  EXPECT_EQ(q->residuals(q, y.data(), told.data(), nullptr), 0);
  EXPECT_EQ(q->remaining(q), 99);
  EXPECT_EQ(q->residuals(q, y.data(), nullptr, told.data()), 0);
  EXPECT_EQ(q->remaining(q), 90);
  EXPECT_EQ(q->residual_count(q, z.data()), 45) << "it is known";
  EXPECT_EQ(q->residuals(q, z.data(), told.data(), told.data()), 0);
  EXPECT_EQ(q->remaining(q), 80);
}

TEST(Interface, TellsABatchAsFarAsTheBudgetGoes) {
  const Problem& problem = problem_named("hs-71");
  const Opened opened = open("hs-71", "", 0, 5);
  Matrix points(4, 7), constraints = Matrix::Constant(2, 7, -1), expected_constraints = constraints;
  Vector objectives = Vector::Constant(7, -1), expected_objectives = objectives;
  for (Eigen::Index k = 0; k < 7; ++k) {
    points.col(k) = problem.lower + static_cast<double>(k) / 8 * (problem.upper - problem.lower);
    if (k >= 5) continue;  // beyond the budget nothing is written
    const Values values = problem.evaluate(points.col(k));
    expected_objectives[k] = values.objective;
    if (k >= 3) expected_constraints.col(k) = values.constraints;
  }
  const auto batch = [&](Eigen::Index first, std::int64_t count, double* its_constraints) {
    return ricochet_values_batch(opened.get(), points.col(first).data(), count, &objectives[first],
                                 its_constraints);
  };
  EXPECT_EQ(batch(0, 3, nullptr), 3);
  EXPECT_EQ(ricochet_remaining(opened.get()), 2);
  EXPECT_EQ(batch(3, 4, constraints.col(3).data()), 2);
  EXPECT_STREQ(ricochet_error(), "the run is over: its budget of 5 evaluations is spent");
  EXPECT_EQ(objectives, expected_objectives);
  EXPECT_EQ(constraints, expected_constraints);
  const Opened other = open("hs-71");
  for (const std::int64_t count : {0, -1, 2}) {
    EXPECT_EQ(ricochet_values_batch(other.get(), nullptr, count, nullptr, nullptr), 0);
  }
  EXPECT_STREQ(ricochet_error(), "the point asked for is NULL");
}

TEST(Interface, StopsWhenTheBudgetIsSpentAndSaysSo) {
  const Opened opened = open("hs-71", "", 0, 3);
  ricochet_problem* const p = opened.get();
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(p->remaining(p), 3 - k);
    EXPECT_FALSE(std::isnan(objective_at(opened, {1.0 + k, 1, 1, 1})));
  }
  EXPECT_EQ(p->remaining(p), 0);
  double objective = 42;
  EXPECT_EQ(p->values(p, p->start, &objective, nullptr), 1);
  EXPECT_EQ(p->derivatives(p, p->start, &objective, nullptr, nullptr, nullptr), 1);
  EXPECT_EQ(objective, 42);
  EXPECT_STREQ(ricochet_error(), "the run is over: its budget of 3 evaluations is spent");
  const Opened squares = open(least_squares, "", 0, 1);
  EXPECT_EQ(squares->residuals(squares.get(), squares->start, nullptr, &objective), 1);
  EXPECT_EQ(objective, 42);
}

TEST(Interface, EndsTheRunThatAsksForNoPoint) {
  const Opened opened = open("hs-71");
  EXPECT_EQ(opened->values(opened.get(), nullptr, nullptr, nullptr), 1);
  EXPECT_STREQ(ricochet_error(), "the point asked for is NULL");
  EXPECT_EQ(opened->remaining(opened.get()), 1000) << "the run goes on";
  objective_at(opened, {1, 1, 1, NAN});
  expect_reason("not finite");
  EXPECT_EQ(opened->remaining(opened.get()), 0);
}

TEST(SeenProblem, ThrowsNothing) {
  Problem problem = parabola(2);
  problem.evaluate = [](const Vector&) -> Values { throw std::runtime_error("broken"); };
  Evaluator evaluator(problem, {100});
  Random random;
  SeenProblem seen(evaluator, problem.start, random);
  double objective = 42;
  EXPECT_EQ(seen.values(&seen, nullptr, &objective, nullptr), 1);
  EXPECT_THROW(std::rethrow_exception(seen.failure()), std::invalid_argument);
  EXPECT_FALSE(evaluator.over());
  EXPECT_EQ(seen.values(&seen, problem.start.data(), &objective, nullptr), 1);
  EXPECT_THROW(std::rethrow_exception(evaluator.failure()), std::runtime_error);
  EXPECT_EQ(objective, 42);
}

TEST(Interface, JudgesByTheTrueValuesOfTheNearestPoint) {
  const Problem& problem = problem_named("top-speed-C1");
  const Opened opened = open("top-speed-C1", "penalised-surrogate");
  const double outside = 1e9, none = infinity;
  double objective = 0;
  EXPECT_EQ(ricochet_judge(opened.get(), &outside, &objective, nullptr), 0);
  EXPECT_EQ(objective, true_values_at(problem, problem.upper).objective);
  EXPECT_EQ(ricochet_judge(opened.get(), &none, nullptr, nullptr), 1);
  expect_reason("not finite");
  EXPECT_EQ(ricochet_judge(opened.get(), nullptr, nullptr, nullptr), 1);
}

TEST(Interface, DrawsFromItsSeed) {
  for (const std::uint64_t seed : {5, 6}) {
    const Opened opened = open("hs-71", "", 0, 1, seed);
    Random same(seed);
    for (const auto draw : {ricochet_uniform, opened->uniform, ricochet_uniform}) {
      EXPECT_EQ(draw(opened.get()), uniform(same));
    }
  }
}

TEST(Interface, RefusesWhatIsNotThere) {
  expect_refusal(open("top-sped-C1"),
                 "top-sped-C1: there is no such problem; did you mean top-speed-C1");
  expect_refusal(open(""), "there is no such problem");
  expect_refusal(open("hs-71", "surrogate"),
                 "surrogate: hs-71 has no such formulation; allowed: original");
  expect_refusal(open("hs-71", "", -1), "instance -1: must be >= 0");
  expect_refusal(open("hs-71", "", 0, 0), "budget 0: must be >= 1");
  expect_refusal(open("hs-71", "", 0, std::numeric_limits<std::int64_t>::min()), "budget -92");
  expect_refusal(Opened(ricochet_open(nullptr, nullptr, 0, 1, 0)), "NULL");
  expect_refusal(open(std::string(1 << 20, 'x') + "\x1b\n\xff"), "bytes ... ");
  EXPECT_EQ(std::string(ricochet_error()).find('\n'), std::string::npos);
  EXPECT_TRUE(Opened(ricochet_open("hs-71", nullptr, 0, 1, 0))) << "the formulation may be NULL";
  const Opened count = open("count-C1", "count");
  EXPECT_EQ(count->derivatives(count.get(), count->start, nullptr, nullptr, nullptr, nullptr), 1);
  EXPECT_STREQ(ricochet_error(), "count-C1 has no derivatives");
  EXPECT_EQ(ricochet_variable_name(count.get(), 1), nullptr);
  EXPECT_STREQ(ricochet_error(), "variable 1: must be from 0 to 0");
}

TEST(Interface, OpensTheProblemsOfAMachineFile) {
  const std::string file = RICOCHET_SOURCE "/examples/machine.toml";
  const auto opened = [](const char* scene, const std::string& name) {
    return Opened(ricochet_open_scene(scene, name.c_str(), "", 0, 1000, 0));
  };
  int same = 0;
  for (const Problem& problem : every_problem(suite_families(file))) {
    if (problem.name != "count-scene" && problem.name != "profile-wear-8-scene") continue;
    expect_same(opened(file.c_str(), problem.name), problem);
    ++same;
  }
  EXPECT_EQ(same, 2);
  expect_refusal(opened(file.c_str(), "count-C1"), "count-C1: there is no such problem");
  expect_refusal(opened("none.toml", "count-scene"), "none.toml");
  expect_refusal(opened(nullptr, "count-scene"), "the machine file has no name");
}

TEST(Interface, KnowsWhichProblemsAreOpen) {
  ricochet_close(nullptr);
  ricochet_problem* const closed = ricochet_open("hs-71", "", 0, 1, 0);
  ricochet_close(closed);
  ricochet_problem stranger{};
  double x[4] = {1, 1, 1, 1}, told = 0;
  for (ricochet_problem* const p : {closed, static_cast<ricochet_problem*>(nullptr), &stranger}) {
    EXPECT_THAT((std::vector<std::int64_t>{ricochet_dimension(p), ricochet_constraints(p),
                                           ricochet_equalities(p), ricochet_has_derivatives(p),
                                           ricochet_has_residuals(p), ricochet_remaining(p)}),
                Each(-1));
    EXPECT_THAT((std::vector{ricochet_best_known(p), ricochet_tolerance(p), ricochet_uniform(p)}),
                Each(testing::IsNan()));
    EXPECT_EQ(ricochet_name(p), nullptr);
    EXPECT_THAT(
        (std::vector{
            ricochet_bounds(p, x, x), ricochet_start(p, x), ricochet_values(p, x, &told, nullptr),
            ricochet_derivatives(p, x, &told, nullptr, nullptr, nullptr),
            ricochet_residuals(p, x, &told, nullptr), ricochet_judge(p, x, nullptr, nullptr)}),
        Each(1));
    EXPECT_EQ(ricochet_values_batch(p, x, 1, &told, nullptr), 0);
    EXPECT_EQ(ricochet_residual_count(p, x), 0);
    EXPECT_STREQ(ricochet_error(), "the problem is not open");
  }
  EXPECT_THAT(x, Each(1.0));
  for (ricochet_problem* const p : {closed, &stranger}) {
    open("nothing");
    ricochet_close(p);
    EXPECT_STREQ(ricochet_error(), "the problem is not open");
  }
}

TEST(Interface, KeepsTheErrorsOfThreadsApart) {
  open("nothing");
  std::string before, after;
  std::thread([&] {
    before = ricochet_error();
    open("hs-71", "sideways");
    after = ricochet_error();
  }).join();
  EXPECT_EQ(before, "");
  EXPECT_THAT(after, HasSubstr("sideways"));
  expect_reason("nothing: there is no such problem");
}

/// Where the sanitizers look for leaks, too, which they see at the end.
TEST(Interface, KeepsNothingOfWhatWasClosed) {
  open("hs-71");
  const std::size_t before = mallinfo2().uordblks;
  for (int k = 0; k < 100'000; ++k) {
    const Opened opened = open("hs-71", "penalised", k % 3);
    objective_at(opened, {1, 1, 1, 1});
  }
  EXPECT_LT(mallinfo2().uordblks, before + 10'000);
}

}  // namespace
}  // namespace ricochet::interface
