#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "src/analysis/statistics/hypothesis_tests.h"

namespace ricochet {
namespace {

constexpr double tolerance = 0.012;  // three deviations of 20,000 draws

void expect_chances(const SignedRankPosterior& posterior, double negative, double equivalent,
                    double positive) {
  EXPECT_NEAR(posterior.negative, negative, tolerance);
  EXPECT_NEAR(posterior.equivalent, equivalent, tolerance);
  EXPECT_NEAR(posterior.positive, positive, tolerance);
}

/// Accuracies [%] of a decision tree less those of naive Bayes on 54 data sets, as published with
/// the Python package baycomp, which computes the same from draws of its own
/// (https://baycomp.readthedocs.io/en/latest/functions.html).
const std::vector<double> tree_less_bayes = {
    2.6963, 5.8262,   -6.142,   -0.4876, 7.3333,  0.0725,  0.0725,  -1.6604, 11.3953,
    -2.87,  0.3766,   -10.4625, -0.5215, 0,       -5.1166, -3.8436, 0.8749,  0.7135,
    0.2667, 11.6462,  -1.8,     0,       -8.7286, 1.4282,  23.1659, 2.528,   4.2393,
    6.882,  -13.5765, 3.2304,   -7.25,   0.8962,  -0.9366, 1.6666,  -6.1899, 2.9957,
    3.3609, 3.357,    4.0266,   -2.0357, 0.4386,  3.0254,  1.8404,  -1.2508, 4.4667,
    15.6,   0.4625,   17.7475,  -5.096,  -3.9761, -7.9772, -2.1596, -0.539,  -1.3727};

TEST(BayesianSignedRank, HasTheChancesPublishedOfClassifiers) {
  expect_chances(bayesian_signed_rank(tree_less_bayes, 1, 1), 0.23014, 0.00674, 0.76312);
}

/// Averaged one-dependence estimators in place of the tree: an example of Benavoli's tutorial
/// (https://github.com/BayesianTestsML/tutorial, Bsignedrank.ipynb), which has 0, 0.12244 and
/// 0.87756 with a prior that weighs 0.6 and not 0.5.
TEST(BayesianSignedRank, HasTheChancesPublishedOfAnotherPairOfClassifiers) {
  const std::vector<double> differences = {
      1.9388,  0.2609, -0.4667, 0.7192,  -2,     0.4637, 0.4637, 0.1506,  7.2688,  0.79,    2.5996,
      -4.3625, 0.614,  0,       0.625,   0.069,  0.2121, 1.6834, -0.2667, 3.2417,  0.8333,  0,
      1.7619,  1.8625, 10.0016, 0.3429,  4.1901, 2.4337, 4.7473, 3.5482,  -0.5833, 10.0427, 0.4435,
      -1.3333, 0.6738, 3.9221,  2.7756,  0.6884, 3.9963, 0.3381, 1.1123,  3.2841,  1.6837,  0.6991,
      0.3667,  5.6,    0.4,     16.9091, 5.04,   1.8095, -0.5,   -0.1426, 0.2023,  0.6818};
  expect_chances(bayesian_signed_rank(differences, 1, 1), 0, 0.12244, 0.87756);
}

/// The prior's weight w is of Beta(1/2, 1), and w^2 of the pairs are of the prior with itself.
TEST(BayesianSignedRank, HasTheChancesOfOneDifferenceInClosedFormulation) {
  const double root = std::sqrt(0.5);
  const double w_below_root = std::sqrt(root);
  const double w_below_rest = std::sqrt(1 - root);
  expect_chances(bayesian_signed_rank({1}, 0.1, 2), 0, 1 - w_below_root, w_below_root);
  expect_chances(bayesian_signed_rank({-1}, 0.1, 2), w_below_root, 1 - w_below_root, 0);
  expect_chances(bayesian_signed_rank({1}, 0.6, 2), 0, 1 - w_below_rest, w_below_rest);
  expect_chances(bayesian_signed_rank({1}, 0.5, 2), 0, 1 - w_below_rest, w_below_rest);  // closed
  expect_chances(bayesian_signed_rank({}, 0, 2), 0, 1, 0);
}

TEST(BayesianSignedRank, IsItsMirrorOfDifferencesReversed) {
  std::vector<double> reversed;
  for (const double x : tree_less_bayes) reversed.push_back(-x);
  const SignedRankPosterior posterior = bayesian_signed_rank(reversed, 1, 3);
  expect_chances(posterior, 0.76312, 0.00674, 0.23014);
  EXPECT_NEAR(posterior.negative + posterior.equivalent + posterior.positive, 1, 1e-12);
}

TEST(BayesianSignedRank, LetsInfiniteDifferencesOutweighAllOthers) {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto infinite = bayesian_signed_rank({infinity, -3, -2, 1, -infinity, infinity}, 0.5, 4);
  const auto large = bayesian_signed_rank({1e6, -3, -2, 1, -1e6, 1e6}, 0.5, 4);
  EXPECT_EQ(infinite.negative, large.negative);
  EXPECT_EQ(infinite.positive, large.positive);
}

TEST(BayesianSignedRank, GivesTheSameForTheSameSeed) {
  const auto positive = [](std::uint64_t seed) {
    return bayesian_signed_rank(tree_less_bayes, 1, seed).positive;
  };
  EXPECT_EQ(positive(5), positive(5));
  EXPECT_NE(positive(5), positive(6));
}

TEST(BayesianSignedRank, RefusesWhatDoesNotFit) {
  EXPECT_THROW(bayesian_signed_rank({std::nan("")}, 1, 1), std::invalid_argument);
  EXPECT_THROW(bayesian_signed_rank({1}, -1, 1), std::invalid_argument);
  EXPECT_THROW(bayesian_signed_rank({1}, std::nan(""), 1), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
