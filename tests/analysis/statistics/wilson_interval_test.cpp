#include <gtest/gtest.h>

#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <stdexcept>

#include "src/analysis/statistics/intervals.h"

namespace ricochet {
namespace {

TEST(WilsonInterval, IsAsPublished) {
  // Newcombe 1998, Statistics in Medicine 17, 857, table I, method 3: four digits.
  struct Published {
    double successes, trials, lower, upper;
  };
  for (const auto& [successes, trials, lower, upper] : {Published{81, 263, 0.2553, 0.3662},
                                                        {15, 148, 0.0624, 0.1605},
                                                        {0, 20, 0, 0.1611},
                                                        {1, 29, 0.0061, 0.1718}}) {
    const Interval interval = wilson_interval(successes, trials);
    EXPECT_NEAR(interval.lower, lower, 5e-5) << successes;
    EXPECT_NEAR(interval.upper, upper, 5e-5) << successes;
  }
}

TEST(WilsonInterval, EndsWhereTheShareIsJustCompatible) {
  const double z = 1.6448536269514722;  // of the normal distribution at 0.95
  for (int trials = 1; trials < 60; ++trials) {
    for (int successes = 0; successes <= trials; ++successes) {
      const Interval interval = wilson_interval(successes, trials, 0.9);
      const double share = static_cast<double>(successes) / trials;
      for (const double p : {interval.lower, interval.upper}) {
        if (p == share) continue;  // 0 and 1 themselves
        EXPECT_NEAR(std::abs(share - p), z * std::sqrt(p * (1 - p) / trials), 1e-12);
      }
      EXPECT_LE(interval.lower, share);
      EXPECT_GE(interval.upper, share);
    }
  }
}

TEST(WilsonInterval, IsShorterThanTheExactOneAndAlikeForFailures) {
  using boost::math::binomial;
  for (int trials = 1; trials <= 100; ++trials) {
    for (int successes = 1; successes < trials; ++successes) {  // without either it may be longer
      const Interval interval = wilson_interval(successes, trials);
      const double exact = binomial::find_upper_bound_on_p(trials, successes, 0.025) -
                           binomial::find_lower_bound_on_p(trials, successes, 0.025);
      EXPECT_LT(interval.upper - interval.lower, exact) << successes << " of " << trials;
      const Interval failures = wilson_interval(trials - successes, trials);
      EXPECT_NEAR(interval.lower, 1 - failures.upper, 1e-15);
    }
  }
}

TEST(WilsonInterval, RefusesCountsThatDoNotFit) {
  EXPECT_THROW(wilson_interval(0, 0), std::invalid_argument);
  EXPECT_THROW(wilson_interval(3, 2), std::invalid_argument);
  EXPECT_THROW(wilson_interval(-1, 2), std::invalid_argument);
  EXPECT_THROW(wilson_interval(1, 2, 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
