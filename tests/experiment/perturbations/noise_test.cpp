// Perturbations by noise, and the draws that all perturbations are made from.

#include "src/experiment/perturbations.h"
#include "tests/experiment/perturbations/random_problem.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

/// Chi-square of counts that should be alike, as deviations from its mean: a normal number, about.
double excess(const std::vector<int>& counts) {
  const auto cells = static_cast<double>(counts.size());
  const double expected = std::accumulate(counts.begin(), counts.end(), 0.0) / cells;
  double chi_square = 0;
  for (const int count : counts) chi_square += std::pow(count - expected, 2) / expected;
  return (chi_square - (cells - 1)) / std::sqrt(2 * (cells - 1));
}

constexpr int draws = 100'000;

/// Ways to come by many numbers in [0, 1): one sequence, and the first number of keys that differ
/// as little as keys can.
std::vector<std::function<double(int)>> sources() {
  return {[draws = Draws(0)](int) mutable { return draws.uniform(); },
          [](int k) { return Draws(key_of(0, static_cast<std::uint64_t>(k))).uniform(); },
          [](int k) { return Draws(key_of(static_cast<std::uint64_t>(k), 0)).uniform(); },
          [](int k) {
            return Draws(key_of(1, Vector{{0.0, 1e-12 * k, 0.0}})).uniform();
          },
          [](int k) {
            const Vector point{{static_cast<double>(k % 300), static_cast<double>(k / 300)}};
            return Draws(key_of(1, point)).uniform();
          }};
}

TEST(Draws, AreTheSequenceOfSplitMix64) {
  // The first numbers from seed 1234567, as published for tests of implementations.
  Draws draws(1234567);
  for (const std::uint64_t bits : {6457827717110365317U, 3203168211198807973U, 9817491932198370423U,
                                   4593380528125082431U, 16408922859458223821U}) {
    EXPECT_EQ(draws.bits(), bits);
  }
}

TEST(Draws, AreUniformAndThoseOfNeighboursIndependentFromWhateverSource) {
  constexpr std::size_t cells = 16;
  for (auto source : sources()) {
    std::vector<std::size_t> drawn;  // the cell of each
    std::array<int, 53> ones = {};
    for (int k = 0; k < draws; ++k) {
      const double number = source(k);
      ASSERT_TRUE(number >= 0 && number < 1) << number;
      drawn.push_back(static_cast<std::size_t>(cells * number));
      const auto bits = static_cast<std::uint64_t>(std::ldexp(number, 53));
      for (std::size_t bit = 0; bit < ones.size(); ++bit) ones[bit] += (bits >> bit) & 1;
    }
    for (const int count : ones) {
      EXPECT_LT(std::abs(2 * count - draws) / std::sqrt(static_cast<double>(draws)), 5);
    }
    for (const std::size_t lag : {1, 2, 300}) {
      std::vector<int> pairs(cells * cells);
      for (std::size_t k = lag; k < draws; ++k) ++pairs[cells * drawn[k - lag] + drawn[k]];
      EXPECT_LT(std::abs(excess(pairs)), 5) << lag;
    }
  }
}

TEST(Draws, ChangeWithEveryBitOfTheKeyAndWithAName) {
  for (const std::uint64_t key : {std::uint64_t{0}, std::uint64_t{1}, UINT64_MAX}) {
    double changed = 0;
    for (int bit = 0; bit < 64; ++bit) {
      const std::uint64_t other = key ^ (std::uint64_t{1} << bit);
      changed += std::popcount(Draws(key_of(key, 0)).bits() ^ Draws(key_of(other, 0)).bits());
    }
    EXPECT_NEAR(changed / 64, 32, 5 * 4 / 8.0);  // a mean of 64 numbers of deviation 4
  }
  EXPECT_NE(key_of(1, "noisy"), key_of(1, "outliers"));
  EXPECT_NE(key_of(1, "noisy"), key_of(2, "noisy"));
}

/// Draws of all points of a grid through the origin, where a product of coordinates would be 0 most
/// of the time.
TEST(Draws, DifferAtDifferentPointsHoweverManyCoordinatesAreZero) {
  std::set<std::uint64_t> keys;
  std::size_t points = 0;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    for (int k = 0; k < 5 * 5 * 5 * 5; ++k) {
      Vector point(4);
      for (int rest = k; double& x : point) x = 0.5 * (rest % 5 - 2), rest /= 5;
      for (const Eigen::Index size : {3, 4}) {
        if (size == 3 && point[3] != 0) continue;  // beside it a point without the last zero
        keys.insert(key_of(seed, Vector(point.head(size))));
        ++points;
      }
    }
  }
  EXPECT_EQ(keys.size(), points);
  EXPECT_EQ(key_of(0, Vector{{0.0, -0.0}}), key_of(0, Vector{{-0.0, 0.0}}));
}

/// The largest distance between the sample's distribution and another, times the root of its size:
/// beyond 1.95 once in a thousand samples.
double kolmogorov(std::vector<double> sample, const std::function<double(double)>& share_below) {
  std::sort(sample.begin(), sample.end());
  double largest = 0;
  for (std::size_t k = 0; k < sample.size(); ++k) {
    const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(sample.size());
    largest = std::max(largest, std::abs(share - share_below(sample[k])));
  }
  return largest * std::sqrt(static_cast<double>(sample.size()));
}

TEST(Draws, AreNormalAndOfTheCauchyDistribution) {
  Draws drawn(7);
  std::vector<double> normal(draws), cauchy(draws);
  for (double& number : normal) number = drawn.normal();
  for (double& number : cauchy) number = drawn.cauchy();
  const auto below = [](double x) { return std::erfc(-x / std::numbers::sqrt2) / 2; };
  EXPECT_LT(kolmogorov(normal, below), 1.95);
  for (double& number : normal) number *= 1.02;
  EXPECT_GT(kolmogorov(normal, below), 1.5);
  EXPECT_LT(kolmogorov(cauchy, [](double x) { return 0.5 + std::atan(x) / std::numbers::pi; }),
            1.95);
}

/// A constant of this value everywhere, as objective, constraint, residual and every slope.
Problem constant(double value) {
  Problem problem = box_problem("constant", 2, 0, 1, 0, [](const Vector&) { return 0.0; });
  problem.constraints = 1;
  problem.evaluate = [value](const Vector&) { return Values{value, Vector::Constant(1, value)}; };
  problem.differentiate = [value, evaluate = problem.evaluate](const Vector& x) {
    return Derivatives{evaluate(x), Vector::Constant(2, value), Matrix::Constant(1, 2, value)};
  };
  problem.residuals = [value](const Vector&) {
    return Residuals{Vector::Constant(1, value), Matrix::Constant(1, 2, value)};
  };
  curve_by(problem, [value](const Vector&) -> Matrix { return Matrix::Constant(2, 2, value); });
  return problem;
}

constexpr int size = 50'000;

using Number = std::function<double(const Problem&, const Vector&)>;

/// One of each kind of number that is told; the first three are values, the others slopes.
const Number kinds[] = {
    [](const Problem& p, const Vector& x) { return p.evaluate(x).objective; },
    [](const Problem& p, const Vector& x) { return p.evaluate(x).constraints[0]; },
    [](const Problem& p, const Vector& x) { return p.residuals(x).values[0]; },
    [](const Problem& p, const Vector& x) { return p.differentiate(x).gradient[1]; },
    [](const Problem& p, const Vector& x) { return p.differentiate(x).jacobian(0, 1); },
    [](const Problem& p, const Vector& x) { return p.residuals(x).jacobian(0, 1); },
    [](const Problem& p, const Vector& x) {
      return p.lagrangian_hessian(x, 1, Vector::Zero(1))(0, 1);
    }};

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

/// The mean of a function of the numbers, and the mean of its squares.
std::pair<double, double> moments(const std::vector<double>& numbers,
                                  const std::function<double(double)>& function) {
  double mean = 0, square = 0;
  for (const double number : numbers) {
    mean += function(number) / size;
    square += std::pow(function(number), 2) / size;
  }
  return {mean, square};
}

TEST(Noise, HasTheMeanDeviationAndTailsOfANormalOne) {
  for (const Perturbation& perturbation : {noisy(), frozen_noise()}) {
    for (const Number& number : kinds) {
      for (const double value : {0.0, -0.5, 3e4}) {
        SCOPED_TRACE(perturbation.name + std::to_string(value));
        const std::vector<double> told = sample(perturbation, value, number);
        const auto [mean, square] = moments(told, [](double noise) { return 1e3 * noise; });
        EXPECT_LT(std::abs(mean), 5 / std::sqrt(size));
        EXPECT_NEAR(square, 1, 5 * std::sqrt(2.0 / size));
        const auto beyond =
            std::ranges::count_if(told, [](double noise) { return std::abs(1e3 * noise) > 2; });
        const double share = std::erfc(std::numbers::sqrt2);
        EXPECT_NEAR(static_cast<double>(beyond) / size, share, 5 * std::sqrt(share / size));
      }
    }
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
  for (std::size_t kind = 0; kind < std::size(kinds); ++kind) {
    for (const double value : {0.0, -0.5, 3e4}) {
      int hit = 0, far = 0, down = 0;
      for (const double told : sample(outliers(), value, kinds[kind])) {
        hit += told != 0;
        far += std::abs(told) > std::numbers::pi / 2;  // as half the Cauchy numbers are
        down += told < 0;
      }
      EXPECT_NEAR(hit, 0.2 * size, 5 * std::sqrt(0.2 * 0.8 * size)) << kind;
      EXPECT_NEAR(far, hit / 2.0, 5 * std::sqrt(hit / 4.0)) << kind;
      const bool is_value = kind < 3;
      EXPECT_NEAR(down, is_value ? 0 : hit / 2.0, is_value ? 0 : 5 * std::sqrt(hit / 4.0)) << kind;
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
  for (int k = 0; k < size; ++k)
    gaps.push_back(told.evaluate(problem.start).objective - 7 - 1.01e-8);
  return gaps;
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
      const Derivatives noisy = noise.perturbed(problem, 2).differentiate(problem.start);
      const double factor = (noisy.values.objective - 1.01e-8) / plain.values.objective;
      EXPECT_NE(factor, 1);
      EXPECT_TRUE(noisy.gradient.isApprox(factor * plain.gradient, 1e-6)) << noise.name;
      EXPECT_EQ(noisy.values.constraints, plain.values.constraints);
      // Another object makes the same draws for its first call.
      const Residuals residuals = noise.perturbed(problem, 2).residuals(problem.start);
      EXPECT_NEAR(residuals.values.squaredNorm() / 2, noisy.values.objective,
                  1e-9 * noisy.values.objective);
    }
  }
}

}  // namespace
}  // namespace ricochet
