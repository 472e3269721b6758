#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "src/experiment/perturbations.h"
#include "tests/experiment/perturbations/random_problem.h"

namespace ricochet {
namespace {

/// A constant of this value everywhere, as objective, constraint, residual and every slope.
Problem constant(double value) {
  Problem problem;
  problem.name = "constant";
  problem.lower = Vector::Zero(2);
  problem.upper = Vector::Ones(2);
  problem.start = Vector::Zero(2);
  problem.constraints = 1;
  problem.evaluate = [value](const Vector&) { return Values{value, Vector::Constant(1, value)}; };
  problem.differentiate = [value, evaluate = problem.evaluate](const Vector& x) {
    return Derivatives{evaluate(x), Vector::Constant(2, value), Matrix::Constant(1, 2, value)};
  };
  problem.residuals = [value](const Vector&) {
    return Residuals{Vector::Constant(1, value), Matrix::Constant(1, 2, value)};
  };
  problem.lagrangian_hessian = [value](const Vector&, double, const Vector&) -> Matrix {
    return Matrix::Constant(2, 2, value);
  };
  return problem;
}

constexpr int size = 50'000;

using Number = std::function<double(const Problem&, const Vector&)>;

/// One of each kind of number that is told.
const std::vector<Number>& kinds() {
  static const std::vector<Number> all = {
      [](const Problem& p, const Vector& x) { return p.evaluate(x).objective; },
      [](const Problem& p, const Vector& x) { return p.evaluate(x).constraints[0]; },
      [](const Problem& p, const Vector& x) { return p.differentiate(x).gradient[1]; },
      [](const Problem& p, const Vector& x) { return p.differentiate(x).jacobian(0, 1); },
      [](const Problem& p, const Vector& x) { return p.residuals(x).values[0]; },
      [](const Problem& p, const Vector& x) { return p.residuals(x).jacobian(0, 1); },
      [](const Problem& p, const Vector& x) {
        return p.lagrangian_hessian(x, 1, Vector::Zero(1))(0, 1);
      }};
  return all;
}

/// What noise did to a constant, at as many points on a line through the origin, in units of the
/// size that it should have.
std::vector<double> sample(const Perturbation& perturbation, double value, const Number& number) {
  const Problem told = perturbation.perturbed(constant(value), 5);
  std::vector<double> all;
  for (int k = 0; k < size; ++k) {
    const Vector x{{static_cast<double>(k) / size, 0.0}};
    all.push_back((number(told, x) - value) / std::max(1.0, std::abs(value)));
  }
  return all;
}

TEST(Noise, HasTheMeanDeviationAndTailsOfANormalOne) {
  for (const Perturbation& perturbation : {noisy(), frozen_noise()}) {
    for (const Number& number : kinds()) {
      for (const double value : {0.0, -0.5, 3e4}) {
        double mean = 0, square = 0, beyond = 0;
        for (const double told : sample(perturbation, value, number)) {
          const double xi = 1e3 * told;
          mean += xi / size;
          square += xi * xi / size;
          beyond += std::abs(xi) > 2;
        }
        EXPECT_LT(std::abs(mean), 5 / std::sqrt(size)) << perturbation.name << value;
        EXPECT_NEAR(square, 1, 5 * std::sqrt(2.0 / size)) << perturbation.name << value;
        const double share = std::erfc(std::numbers::sqrt2);
        EXPECT_NEAR(beyond / size, share, 5 * std::sqrt(share / size))
            << perturbation.name << value;
      }
    }
  }
}

TEST(Noise, OfObjectiveAndConstraintIsIndependent) {
  for (const Perturbation& perturbation : {noisy(), frozen_noise()}) {
    const std::vector<double> a = sample(perturbation, 0, kinds()[0]);
    const std::vector<double> b = sample(perturbation, 0, kinds()[1]);
    double together = 0;
    for (std::size_t k = 0; k < a.size(); ++k) together += 1e6 * a[k] * b[k] / size;
    EXPECT_LT(std::abs(together), 5 / std::sqrt(size));
  }
}

TEST(Noise, IsDrawnAnewUnlessItIsFrozen) {
  const Vector x{{0.0, 0.0}};
  const Problem frozen = frozen_noise().perturbed(constant(0), 5);
  EXPECT_EQ(frozen.evaluate(x).objective, frozen.evaluate(x).objective);
  const Problem anew = noisy().perturbed(constant(0), 5);
  double mean = 0;
  for (int k = 0; k < size; ++k) mean += 1e3 * anew.evaluate(x).objective / size;
  EXPECT_LT(std::abs(mean), 5 / std::sqrt(size)) << "averaging helps";
}

TEST(Noise, LeavesAloneWhatIsNotFinite) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Perturbation& perturbation : {noisy(), frozen_noise(), outliers()}) {
    const Problem told = perturbation.perturbed(constant(-infinity), 1);
    const Problem lost = perturbation.perturbed(constant(std::nan("")), 1);
    for (int k = 0; k < 100; ++k) {
      const Vector x{{0.01 * k, 0.0}};
      EXPECT_EQ(told.evaluate(x).objective, -infinity);
      EXPECT_TRUE(std::isnan(lost.evaluate(x).objective));
    }
  }
}

TEST(Outliers, AreAFifthOfAllWithTheTailOfACauchyNumber) {
  for (std::size_t kind = 0; kind < kinds().size(); ++kind) {
    const bool is_value = kind == 0 || kind == 1 || kind == 4;
    for (const double value : {0.0, -0.5, 3e4}) {
      int hit = 0, far = 0, down = 0;
      for (const double told : sample(outliers(), value, kinds()[kind])) {
        hit += told != 0;
        far += std::abs(told) > std::numbers::pi / 2;  // as half the Cauchy numbers are
        down += told < 0;
      }
      EXPECT_NEAR(hit, 0.2 * size, 5 * std::sqrt(0.2 * 0.8 * size)) << kind;
      EXPECT_NEAR(far, hit / 2.0, 5 * std::sqrt(hit / 4.0)) << kind;
      if (is_value) {
        EXPECT_EQ(down, 0) << kind;
      } else {
        EXPECT_NEAR(down, hit / 2.0, 5 * std::sqrt(hit / 4.0)) << kind;
      }
    }
  }
}

TEST(Outliers, StayWhereTheyAreAndTakeTheGradientWithThem) {
  const Problem told = outliers().perturbed(constant(0), 2);
  int hit = 0;
  for (int k = 0; k < 1000; ++k) {
    const Vector x{{0.001 * k, 0.0}};
    const Derivatives d = told.differentiate(x);
    EXPECT_EQ(d.values.objective, told.evaluate(x).objective);
    EXPECT_EQ(d.values.objective != 0, d.gradient[0] != 0);
    EXPECT_EQ(d.values.constraints[0] != 0, d.jacobian(0, 1) != 0);
    hit += d.values.objective != 0 && d.values.constraints[0] != 0;
  }
  EXPECT_NEAR(hit, 40, 5 * std::sqrt(40)) << "objective and constraint, each by itself";
}

/// What a noise of BBOB's makes of the optimality gap of a problem of two variables, call by call.
std::vector<double> noisy_gaps(const Perturbation& perturbation, double gap) {
  Problem problem = constant(gap + 7);
  problem.best_known = 7;
  const Problem told = perturbation.perturbed(problem, 5);
  std::vector<double> gaps;
  for (int k = 0; k < size; ++k) {
    gaps.push_back(told.evaluate(problem.start).objective - 7 - 1.01e-8);
  }
  return gaps;
}

/// The mean of the numbers and the mean of their squares.
template <class Function>
std::pair<double, double> moments(const std::vector<double>& numbers, const Function& function) {
  double mean = 0, square = 0;
  for (const double number : numbers) {
    mean += function(number) / size;
    square += std::pow(function(number), 2) / size;
  }
  return {mean, square};
}

TEST(NoiseOfBbob, IsOfThePublishedModels) {
  const auto logarithm = [](double gap) { return std::log(gap); };
  const auto [mean, square] = moments(noisy_gaps(bbob_gaussian(), 1), logarithm);
  EXPECT_NEAR(mean, 0, 5 / std::sqrt(size));
  EXPECT_NEAR(square, 1, 5 * std::sqrt(2.0 / size));
  // Far from the best value one uniform factor is left: of mean 1/2, and 1/3 for its square.
  const auto [far, far_square] =
      moments(noisy_gaps(bbob_uniform(), 1e9), [](double gap) { return gap / 1e9; });
  EXPECT_NEAR(far, 0.5, 5 / std::sqrt(12.0 * size));
  EXPECT_NEAR(far_square, 1.0 / 3, 5 * 0.3 / std::sqrt(size));
  // At a gap of 1 the logarithm is that of a uniform number, and a uniform number in [0, s).
  const double s = (0.49 + 0.5) * std::log(1e9);
  const auto [near, near_square] = moments(noisy_gaps(bbob_uniform(), 1), logarithm);
  EXPECT_NEAR(near, s / 2 - 1, 5 * s / std::sqrt(12.0 * size));
  EXPECT_NEAR(near_square - near * near, 1 + s * s / 12, 5 * s * s / 12 / std::sqrt(size));
  int outliers = 0, beyond = 0;
  for (const double gap : noisy_gaps(bbob_cauchy(), 3)) {
    EXPECT_GE(gap, 3 - 1e-8);
    outliers += std::abs(gap - 1003) > 1e-8;
    beyond += std::abs(gap - 1003) > 1;  // half of all Cauchy numbers
  }
  EXPECT_NEAR(outliers, 0.2 * size, 5 * std::sqrt(0.16 * size));
  EXPECT_NEAR(beyond, outliers / 2.0, 5 * std::sqrt(outliers / 4.0));
}

TEST(NoiseOfBbob, LeavesSolvedPointsAlone) {
  for (const Perturbation& noise : {bbob_gaussian(), bbob_uniform(), bbob_cauchy()}) {
    EXPECT_NEAR(noisy_gaps(noise, 5e-9).front() + 1.01e-8, 5e-9, 1e-14) << noise.name;
    EXPECT_FALSE(noise.applies(constant(1))) << "no best value is known";
  }
}

TEST(NoiseOfBbob, IsOfOneKindForObjectiveResidualsAndSlopes) {
  for (const Problem& problem : random_problems()) {
    for (const Perturbation& noise : {bbob_gaussian(), bbob_uniform()}) {
      const Derivatives plain = problem.differentiate(problem.start);
      const Problem told = noise.perturbed(problem, 2);
      const Derivatives noisy = told.differentiate(problem.start);
      const double factor = (noisy.values.objective - 1.01e-8) / plain.values.objective;
      EXPECT_NE(factor, 1);
      EXPECT_TRUE(noisy.gradient.isApprox(factor * plain.gradient, 1e-6)) << noise.name;
      EXPECT_EQ(noisy.values.constraints, plain.values.constraints);
      // Another object makes the same draws for its first call.
      const Problem again = noise.perturbed(problem, 2);
      const Residuals residuals = again.residuals(problem.start);
      EXPECT_NEAR(residuals.values.squaredNorm() / 2, noisy.values.objective,
                  1e-9 * noisy.values.objective);
    }
  }
}

}  // namespace
}  // namespace ricochet
