// libricochet.so, from outside, against the problems it is made of.

#include <malloc.h>
#include <ricochet/ricochet.h>

#include <latch>
#include <regex>

#include "ricochet/problem.h"
#include "ricochet/random.h"
#include "src/core/instance.h"
#include "src/studies/suite/suite.h"
#include "tests/interface/opened.h"
#include "tests/support/files.h"
#include "tests/support/numbers.h"
#include "tests/support/test.h"

namespace ricochet::interface {
namespace {

using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;

Vector vector_at(const double* numbers, Eigen::Index size) {
  return Eigen::Map<const Vector>(numbers, size);
}

/// NaN where it cannot be asked.
double objective_at(const Opened& opened, const Vector& x) {
  double objective = 0;
  const bool over = opened->values(opened.get(), x.data(), &objective, nullptr) != 0;
  return over ? NAN : objective;
}

/// The two are the same in every bit, at a few points.
void expect_same(const Opened& opened, const Problem& problem) {
  ASSERT_TRUE(opened) << ricochet_error();
  const Eigen::Index n = problem.dimension(), m = problem.constraints;
  ASSERT_EQ(opened->dimension, n);
  ASSERT_EQ(opened->constraints, m);
  EXPECT_EQ(opened->equalities, problem.equalities);
  EXPECT_EQ(opened->has_derivatives != 0, static_cast<bool>(problem.differentiate));
  EXPECT_EQ(opened->name, problem.name);
  EXPECT_EQ(vector_at(opened->lower, n), problem.lower);
  EXPECT_EQ(vector_at(opened->upper, n), problem.upper);
  EXPECT_EQ(vector_at(opened->start, n), problem.start);
  Random random(1);
  for (int k = 0; k < 3; ++k) {
    const Vector x = k == 0 ? problem.start : uniform_point(problem, random);
    const Values expected = problem.evaluate(x);
    double objective = 0;
    Vector constraints(m);
    ASSERT_EQ(opened->values(opened.get(), x.data(), &objective, constraints.data()), 0)
        << ricochet_error();
    EXPECT_EQ(objective, expected.objective);
    EXPECT_EQ(constraints, expected.constraints);
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

TEST(Interface, TellsExactDerivativesRowByRowWhereThereAreSome) {
  const Problem& problem = problem_named("hs-71");
  const Opened opened = open("hs-71");
  Vector gradient(4);
  Eigen::Matrix<double, 2, 4, Eigen::RowMajor> jacobian;
  double objective = 0;
  ASSERT_EQ(opened->derivatives(opened.get(), opened->start, &objective, nullptr, gradient.data(),
                                jacobian.data()),
            0);
  const Derivatives expected = problem.differentiate(problem.start);
  EXPECT_EQ(objective, expected.values.objective);
  EXPECT_EQ(gradient, expected.gradient);
  EXPECT_EQ(Matrix(jacobian), expected.jacobian);
  EXPECT_EQ(opened->remaining(opened.get()), 995);
  const Opened count = open("count-C1", "count");
  EXPECT_EQ(count->has_derivatives, 0);
  EXPECT_EQ(count->derivatives(count.get(), count->start, nullptr, nullptr, nullptr, nullptr), 1);
  EXPECT_STREQ(ricochet_error(), "count-C1 has no derivatives");
}

TEST(Interface, StopsWhenTheBudgetIsSpentAndSaysSo) {
  const Opened opened = open("hs-71", "", 0, 3);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(opened->remaining(opened.get()), 3 - k);
    EXPECT_FALSE(std::isnan(objective_at(opened, Vector::Constant(4, 1.0 + k))));
  }
  EXPECT_EQ(opened->remaining(opened.get()), 0);
  EXPECT_TRUE(std::isnan(objective_at(opened, Vector::Constant(4, 4.5))));
  EXPECT_STREQ(ricochet_error(), "the run is over: its budget of 3 evaluations is spent");
}

TEST(Interface, EndsTheRunThatAsksForNoPoint) {
  const Opened opened = open("hs-71");
  EXPECT_EQ(opened->values(opened.get(), nullptr, nullptr, nullptr), 1);
  EXPECT_STREQ(ricochet_error(), "the point asked for is NULL");
  EXPECT_EQ(opened->remaining(opened.get()), 1000) << "the run goes on";
  objective_at(opened, Vector::Constant(4, NAN));
  expect_reason("not finite");
  EXPECT_EQ(opened->remaining(opened.get()), 0);
}

TEST(Interface, JudgesByTheTrueValuesWhateverIsShown) {
  const Problem& problem = problem_named("top-speed-C1");
  const Opened opened = open("top-speed-C1", "penalised-surrogate", 0, 1);
  double objective = 0, violation = -1;
  const auto judged = [&](const double* x) {
    return ricochet_judge(opened.get(), x, &objective, &violation);
  };
  Random random(3);
  for (int k = 0; k < 10; ++k) {
    const Vector x = uniform_point(problem, random);
    ASSERT_EQ(judged(x.data()), 0);
    EXPECT_THAT(true_values_at(problem, x), testing::FieldsAre(objective, violation));
  }
  EXPECT_EQ(opened->remaining(opened.get()), 1) << "it costs nothing";
  const double outside = 1e9, none = infinity;
  EXPECT_EQ(judged(&outside), 0);
  EXPECT_EQ(objective, true_values_at(problem, problem.upper).objective);
  EXPECT_EQ(judged(&none), 1);
  expect_reason("not finite");
  EXPECT_EQ(judged(nullptr), 1);
}

TEST(Interface, DrawsTheSameNumbersFromTheSameSeed) {
  const auto draws = [](std::uint64_t seed) {
    const Opened opened = open("hs-71", "", 0, 1, seed);
    std::vector<double> numbers;
    for (int k = 0; k < 100; ++k) numbers.push_back(opened->uniform(opened.get()));
    return numbers;
  };
  EXPECT_EQ(draws(5), draws(5));
  EXPECT_NE(draws(5), draws(6));
  EXPECT_THAT(draws(5), Each(AllOf(testing::Ge(0), testing::Lt(1))));
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
}

TEST(Interface, OpensTheProblemsOfAMachineFile) {
  const std::string file = RICOCHET_SOURCE "/examples/machine.toml";
  const auto opened = [](const char* scene, const std::string& name) {
    return Opened(ricochet_open_scene(scene, name.c_str(), "", 0, 10, 0));
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
  ricochet_problem* const problem = ricochet_open("hs-71", "", 0, 1, 0);
  ricochet_close(problem);
  ricochet_close(problem);
  EXPECT_STREQ(ricochet_error(), "the problem is not open");
  const Vector x = Vector::Ones(4);
  ricochet_problem stranger{};
  for (ricochet_problem* const other :
       {problem, static_cast<ricochet_problem*>(nullptr), &stranger}) {
    EXPECT_EQ(ricochet_judge(other, x.data(), nullptr, nullptr), 1);
  }
  ricochet_close(&stranger);
}

TEST(Interface, KeepsTheErrorsOfThreadsApart) {
  open("nothing");
  std::string before, after;
  in_threads(1, [&](std::size_t) {
    before = ricochet_error();
    open("hs-71", "sideways");
    after = ricochet_error();
  });
  EXPECT_EQ(before, "");
  EXPECT_THAT(after, HasSubstr("sideways"));
  expect_reason("nothing: there is no such problem");
}

TEST(Interface, IsUsedByManyThreadsAtOnce) {
  const Vector x = Vector::Constant(1, 5.0);
  const double expected = objective_at(open("count-C4", "surrogate"), x);
  std::vector<double> found(8);
  in_threads(8, [&](std::size_t t) {
    for (int k = 0; k < 100; ++k) found[t] = objective_at(open("count-C4", "surrogate"), x);
  });
  EXPECT_THAT(found, Each(expected));
}

/// By the problem's own functions and by those of the library, asked for in parts.
TEST(Interface, SharesAProblemAmongThreads) {
  const Opened problem = open("top-speed-C1", "surrogate", 0, 1'000'000);
  constexpr std::size_t threads_at_once = 4, points = 4000;
  std::latch begin(threads_at_once);
  const auto asked = [&](std::size_t k) {
    const double x = 0.5 + 17.0 * static_cast<double>(k) / points;
    std::array<double, 6> told{};
    ricochet_values(problem.get(), &x, &told[0], nullptr);
    problem->values(problem.get(), &x, nullptr, &told[1]);
    problem->derivatives(problem.get(), &x, nullptr, nullptr, &told[2], &told[3]);
    ricochet_judge(problem.get(), &x, &told[4], &told[5]);
    return told;
  };
  std::vector<std::array<double, 6>> expected, found(points);
  for (std::size_t k = 0; k < points; ++k) expected.push_back(asked(k));
  in_threads(threads_at_once, [&](std::size_t first) {
    begin.arrive_and_wait();
    for (std::size_t k = first; k < points; k += threads_at_once) found[k] = asked(k);
  });
  EXPECT_EQ(found, expected);
}

TEST(Interface, SaysEachThreadWhyItsCallWasRefused) {
  const Opened problem = open("hs-71", "", 0, 100);
  std::atomic<int> answered = 0, told = 0;
  in_threads(4, [&](std::size_t) {
    for (int k = 0; k < 100; ++k) {
      const bool refused = std::isnan(objective_at(problem, Vector::Ones(4)));
      const std::string why = ricochet_error();
      ++(refused ? told : answered);
      EXPECT_EQ(why.find("100 evaluations is spent") != std::string::npos, refused);
    }
  });
  EXPECT_EQ(answered, 100);
  EXPECT_EQ(told, 300);
}

/// What is closed stays until its last call has returned.
TEST(Interface, ClosesAProblemThatAnotherThreadUses) {
  for (int repeat = 0; repeat < 20; ++repeat) {
    ricochet_problem* const problem = ricochet_open("count-C4", "surrogate", 0, 1000, 0);
    std::thread user([problem] {
      const double x = 5;
      double objective = 0;
      while (ricochet_values(problem, &x, &objective, nullptr) == 0) {
      }
    });
    ricochet_close(problem);
    user.join();
  }
}

/// Where the sanitizers look for leaks, too, which they see at the end.
TEST(Interface, KeepsNothingOfWhatWasClosed) {
  open("hs-71");
  const std::size_t before = mallinfo2().uordblks;
  for (int k = 0; k < 100'000; ++k) {
    const Opened opened = open("hs-71", "penalised", k % 3);
    objective_at(opened, Vector::Ones(4));
  }
  EXPECT_LT(mallinfo2().uordblks, before + 10'000);
}

/// What a pattern's group finds in a text.
std::set<std::string> found_in(const std::string& text, const char* pattern) {
  const std::regex wanted(pattern);
  return {std::sregex_token_iterator(text.begin(), text.end(), wanted, 1), {}};
}

std::string printed_by(const std::string& command) {
  FILE* const pipe = popen(command.c_str(), "r");
  if (!pipe) throw std::runtime_error(command);
  std::string text;
  for (int c = 0; (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
  EXPECT_EQ(pclose(pipe), 0) << command;
  return text;
}

TEST(Interface, ExportsTheFunctionsThatItsHeaderDeclares) {
  const auto declared =
      found_in(text_of(std::filesystem::path(RICOCHET_SOURCE "/include/ricochet/ricochet.h")),
               R"((?:^|\n)[a-z][a-z0-9_ ]*[ *]+(ricochet_[a-z_]+)\()");
  EXPECT_THAT(declared, IsSupersetOf({"ricochet_open", "ricochet_values", "ricochet_counts"}));
  EXPECT_EQ(
      found_in(printed_by("nm --dynamic --defined-only --format=just-symbols " RICOCHET_LIBRARY),
               "(.+)\n"),
      declared);
}

/// So that it runs where these are not: from a wheel of Python.
TEST(Interface, NeedsNoOtherLibraryThanTbbAndThoseOfTheCompiler) {
  const auto needed = found_in(printed_by("readelf --dynamic --wide " RICOCHET_LIBRARY),
                               R"(\(NEEDED\) +Shared library: \[([^\]]+)\])");
  const std::set<std::string> allowed = {"libtbb.so.12",  "libstdc++.so.6", "libm.so.6",
                                         "libgcc_s.so.1", "libc.so.6",      "ld-linux-x86-64.so.2"};
  EXPECT_THAT(needed, testing::Contains("libc.so.6"));
  EXPECT_THAT(allowed, IsSupersetOf(needed));
}

/// So that a program that was built with one version of the header runs with another, unless
/// RICOCHET_ABI says that it cannot.
TEST(Interface, KeepsTheLayoutOfItsStructures) {
  EXPECT_EQ(ricochet_abi(), RICOCHET_ABI);
  static_assert(RICOCHET_ABI == 3, "a new layout: write down its offsets here");
  if (sizeof(void*) != 8) GTEST_SKIP() << "the offsets are those of 64 bits";
  using P = ricochet_problem;
  EXPECT_THAT((std::vector{
                  offsetof(P, abi), offsetof(P, dimension), offsetof(P, constraints),
                  offsetof(P, equalities), offsetof(P, has_derivatives), offsetof(P, has_residuals),
                  offsetof(P, name), offsetof(P, lower), offsetof(P, upper), offsetof(P, start),
                  offsetof(P, values), offsetof(P, derivatives), offsetof(P, residual_count),
                  offsetof(P, residuals), offsetof(P, remaining), offsetof(P, uniform), sizeof(P)}),
              ElementsAre(0, 4, 8, 12, 16, 20, 24, 32, 40, 48, 56, 64, 72, 80, 88, 96, 104));
  using S = ricochet_solver;
  EXPECT_THAT((std::vector{offsetof(S, abi), offsetof(S, name), offsetof(S, version),
                           offsetof(S, takes_constraints), offsetof(S, needs_derivatives),
                           offsetof(S, needs_residuals), offsetof(S, stochastic),
                           offsetof(S, solve), sizeof(S)}),
              ElementsAre(0, 8, 16, 24, 28, 32, 36, 40, 48));
}

}  // namespace
}  // namespace ricochet::interface
