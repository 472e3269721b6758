// Solvers on a problem that a program fills in, against closed forms and what its functions
// returned.

#include <ricochet/minimise.h>

#include <cmath>
#include <functional>

#include "tests/support/test.h"

namespace ricochet::interface {
namespace {

using Numbers = std::vector<double>;

/// A problem that a program fills in, whose functions are those of C++; it counts their calls.
struct Own : ricochet_problem {
  explicit Own(Numbers from, Numbers to, Numbers begin)
      : ricochet_problem(), low(std::move(from)), high(std::move(to)), first(std::move(begin)) {
    abi = RICOCHET_ABI;
    dimension = static_cast<std::int32_t>(low.size());
    lower = low.data();
    upper = high.data();
    start = first.data();
    values = [](ricochet_problem* p, const double* x, double* objective, double* constraints) {
      Own& own = *static_cast<Own*>(p);
      ++own.calls;
      own.firsts.push_back(x[0]);
      return own.at(x, objective, constraints);
    };
    residual_count = [](ricochet_problem*, const double*) { return std::int32_t{2}; };
    residuals = [](ricochet_problem* p, const double* x, double* r, double* jacobian) {
      ++static_cast<Own*>(p)->calls;
      if (jacobian) std::copy_n(Numbers{-20 * x[0], 10, -1, 0}.begin(), 4, jacobian);
      if (r) std::copy_n(Numbers{10 * (x[1] - x[0] * x[0]), 1 - x[0]}.begin(), 2, r);
      return 0;
    };
  }

  Numbers low, high, first;
  std::function<std::int32_t(const double*, double*, double*)> at;
  std::int64_t calls = 0;
  Numbers firsts;  ///< first coordinates of the points of `values`
};

/// (x - 1)^2 + (y + 2)^2 within [-5, 5]^2, from (4, 4).
Own bowl() {
  Own own({-5, -5}, {5, 5}, {4, 4});
  own.at = [](const double* x, double* objective, double*) {
    *objective = std::pow(x[0] - 1, 2) + std::pow(x[1] + 2, 2);
    return 0;
  };
  return own;
}

struct Answer : ricochet_minimisation {
  Numbers x;
  std::int32_t code = 0;
};

Answer solved(Own& own, const char* solver, std::int64_t budget = 500, std::int32_t seed = 0,
              std::int64_t gradient_cost = 0, std::int32_t jumps = 0) {
  Answer answer{};
  answer.x.resize(own.low.size());
  answer.abi = RICOCHET_ABI;
  answer.solver = solver;
  answer.budget = budget;
  answer.seed = seed;
  answer.gradient_cost = gradient_cost;
  answer.jumps = jumps;
  answer.point = answer.x.data();
  answer.code = ricochet_minimise(&own, &answer);
  return answer;
}

TEST(Minimise, FindsTheBestPointOfABox) {
  Own own = bowl();
  const Answer answer = solved(own, nullptr);
  EXPECT_EQ(answer.code, 0) << answer.ended;
  EXPECT_STREQ(answer.chosen, "nlopt-mlsl-bobyqa");
  EXPECT_THAT(answer.why, StartsWith("values alone: "));
  EXPECT_NEAR(answer.x[0], 1, 1e-6);
  EXPECT_NEAR(answer.x[1], -2, 1e-6);
  double objective = NAN;
  own.at(answer.x.data(), &objective, nullptr);
  EXPECT_EQ(answer.objective, objective);
  EXPECT_EQ(answer.violation, 0);
  EXPECT_EQ(answer.evaluations, 500);
  EXPECT_EQ(own.calls, 500) << "nothing is asked that is not charged";
  EXPECT_EQ(own.firsts[0], 4) << "it begins where it was told to";
}

/// x + y with x y = 2 and x <= 1 is least at (1, 2): along y = 2 / x the sum falls up to sqrt(2).
TEST(Minimise, TakesConstraintsAndTheirDerivatives) {
  Own own({0.1, 0.1}, {5, 5}, {0.5, 3});
  own.constraints = 2;
  own.equalities = 1;
  own.at = [](const double* x, double* objective, double* constraints) {
    if (objective) *objective = x[0] + x[1];
    if (constraints) std::copy_n(Numbers{x[0] * x[1] - 2, x[0] - 1}.begin(), 2, constraints);
    return 0;
  };
  own.derivatives = [](ricochet_problem* p, const double* x, double* objective, double* constraints,
                       double* gradient, double* jacobian) {
    std::fill_n(gradient, 2, 1.0);
    std::copy_n(Numbers{x[1], x[0], 1, 0}.begin(), 4, jacobian);
    return static_cast<Own*>(p)->at(x, objective, constraints);
  };
  for (const char* solver : {"nlopt-cobyla", "nlopt-slsqp", "nlopt-bobyqa"}) {
    own.has_derivatives = std::string(solver) == "nlopt-slsqp";
    const Answer answer = solved(own, solver, 5000);
    EXPECT_EQ(answer.code, 0) << answer.ended;
    const bool penalised = std::string(solver) == "nlopt-bobyqa";
    EXPECT_NEAR(answer.objective, 3, penalised ? 0.3 : 1e-5) << solver;
    EXPECT_EQ(answer.violation, 0) << solver;
    if (!own.has_derivatives) {
      EXPECT_EQ(own.calls, answer.evaluations) << solver;
    }
    own.calls = 0;
  }
}

TEST(Minimise, TakesResidualsWithAndWithoutJacobian) {
  for (const bool derivatives : {true, false}) {
    Own own({-2, -2}, {2, 2}, {-1.2, 1});
    own.at = [](const double* x, double* objective, double*) {
      *objective = 50 * std::pow(x[1] - x[0] * x[0], 2) + 0.5 * std::pow(1 - x[0], 2);
      return 0;
    };
    own.has_residuals = 1;
    own.has_derivatives = derivatives ? 1 : 0;
    own.derivatives = [](ricochet_problem*, const double*, double*, double*, double*, double*) {
      return 1;
    };
    const Answer answer = solved(own, "ceres-trust-region", 300);
    ASSERT_EQ(answer.code, 0) << answer.ended;
    EXPECT_NEAR(answer.x[0], 1, 1e-6);
    EXPECT_NEAR(answer.x[1], 1, 1e-6);
    EXPECT_TRUE(own.firsts.empty()) << "the value is half the squares of the residuals";
    if (derivatives) {
      EXPECT_LT(own.calls, answer.evaluations);
    } else {
      EXPECT_EQ(own.calls, answer.evaluations);
    }
  }
}

TEST(Minimise, ChargesAnEvaluationThatFailsAndGoesOn) {
  Own own = bowl();
  std::int64_t failed = 0;
  own.at = [&](const double* x, double* objective, double*) {
    if (x[0] > 1.5) {
      ++failed;
      if (failed % 2 == 0) *objective = -1;  // which does not count
      return failed % 2 == 0 ? 1 : 0;        // says so, or leaves NaN
    }
    *objective = std::pow(x[0] - 1, 2) + std::pow(x[1] + 2, 2);
    return 0;
  };
  const Answer answer = solved(own, "mads-tuned");
  EXPECT_EQ(answer.code, 0) << answer.ended;
  EXPECT_GT(failed, 10);
  EXPECT_EQ(answer.failed, failed);
  EXPECT_EQ(answer.evaluations, own.calls);
  EXPECT_NEAR(answer.objective, 0, 1e-6);

  own.at = [](const double*, double*, double*) { return 1; };
  const Answer none = solved(own, "random-search", 20);
  EXPECT_EQ(none.code, 0);
  EXPECT_EQ(none.failed, 20);
  EXPECT_TRUE(std::isnan(none.objective) && std::isnan(none.x[0]));
}

TEST(Minimise, EndsWhenTheFunctionSaysSo) {
  Own own = bowl();
  own.at = [&own, at = own.at](const double* x, double* objective, double* constraints) {
    return own.calls == 7 ? -1 : at(x, objective, constraints);
  };
  const Answer answer = solved(own, "nlopt-cobyla");
  EXPECT_EQ(answer.code, 0);
  EXPECT_EQ(own.calls, 7);
  EXPECT_STREQ(answer.ended, "stopped by the function");
  EXPECT_LT(answer.objective, 45) << "the best so far is not lost";
}

TEST(Minimise, ChargesAGradientWhatItIsSaidToCost) {
  Own own = bowl();
  own.has_derivatives = 1;
  own.derivatives = [](ricochet_problem* p, const double* x, double* objective, double*,
                       double* gradient, double*) {
    Own& asked = *static_cast<Own*>(p);
    ++asked.calls;
    std::copy_n(Numbers{2 * (x[0] - 1), 2 * (x[1] + 2)}.begin(), 2, gradient);
    return asked.at(x, objective, nullptr);
  };
  EXPECT_EQ(solved(own, "nlopt-lbfgs", 300).code, 0);
  EXPECT_EQ(own.calls, 100) << "as many evaluations as there are variables";
  own.calls = 0;
  EXPECT_EQ(solved(own, "nlopt-lbfgs", 300, 0, 1).code, 0);
  EXPECT_EQ(own.calls, 150);
}

TEST(Minimise, ChoosesByWhatIsDeclared) {
  Own own = bowl();
  const Answer answer = solved(own, "auto", 300, 0, 0, 1);
  EXPECT_THAT(answer.why, StartsWith("values that jump: "));
  EXPECT_STREQ(solved(own, "auto", 300).chosen, "nlopt-mlsl-bobyqa");
}

TEST(Minimise, RepeatsARunOfTheSameSeedToTheBit) {
  Own first = bowl(), again = bowl(), other = bowl();
  const Answer answer = solved(first, "pagmo-cmaes", 200, 3);
  EXPECT_EQ(solved(again, "pagmo-cmaes", 200, 3).objective, answer.objective);
  EXPECT_EQ(first.firsts, again.firsts);
  solved(other, "pagmo-cmaes", 200, 4);
  EXPECT_NE(first.firsts, other.firsts);
  EXPECT_EQ(first.firsts[0], other.firsts[0]) << "each begins at the start";
}

TEST(Minimise, SaysWhatIsWrong) {
  const auto expect_error = [](const char* reason, const char* solver,
                               const std::function<void(Own&)>& change, std::int64_t budget = 10) {
    Own own = bowl();
    change(own);
    const Answer answer = solved(own, solver, budget);
    EXPECT_EQ(answer.code, 1);
    EXPECT_THAT(answer.ended, HasSubstr(reason));
    EXPECT_EQ(own.calls, 0);
  };
  const auto as_it_is = [](Own&) {};
  expect_error("nlopt-cobila: there is no such solver; did you mean nlopt-cobyla", "nlopt-cobila",
               as_it_is);
  expect_error(
      "ipopt does not take the problem: variables: any number; constraints: all; needs: gradients",
      "ipopt", as_it_is);
  expect_error("budget 0: must be >= 1", "auto", as_it_is, 0);
  expect_error("made for interface 2, this is 3", "auto", [](Own& own) { own.abi = 2; });
  expect_error("dimension 0: must be >= 1", "auto", [](Own& own) { own.dimension = 0; });
  expect_error("start[1] = 6: must be from -5 to 5", "auto", [](Own& own) { own.first[1] = 6; });
  expect_error("upper[0] = -7: must be >= lower[0] = -5", "auto",
               [](Own& own) { own.high[0] = -7; });
  expect_error("lower[1] = nan: must be finite", "auto", [](Own& own) { own.low[1] = NAN; });
  expect_error("equalities 1: must be from 0 to the number of constraints, 0", "auto",
               [](Own& own) { own.equalities = 1; });
  expect_error("values is NULL", "auto", [](Own& own) { own.values = nullptr; });
  expect_error("residual_count 0: must be >= 1", "auto", [](Own& own) {
    own.has_residuals = 1;
    own.residual_count = [](ricochet_problem*, const double*) { return std::int32_t{0}; };
  });
  expect_error("name \"a b\"; allowed are", "auto", [](Own& own) { own.name = "a b"; });
  EXPECT_EQ(ricochet_minimise(nullptr, nullptr), 1);
}

TEST(Minimise, KeepsTheLayoutOfItsStructure) {
  static_assert(RICOCHET_ABI == 3, "a new layout: write down its size here");
  if (sizeof(void*) != 8) GTEST_SKIP() << "the size is that of 64 bits";
  EXPECT_EQ(sizeof(ricochet_minimisation), 112U);
}

}  // namespace
}  // namespace ricochet::interface
