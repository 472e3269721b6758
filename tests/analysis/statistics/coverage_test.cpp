#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include "ricochet/random.h"
#include "src/analysis/statistics/intervals.h"
#include "src/analysis/statistics/ranking.h"
#include "src/analysis/statistics/running_time.h"

/// How often each interval of 95 % holds the true objective, where the true objective is known. The
/// figures are printed.
namespace ricochet {
namespace {

bool holds(const Interval& interval, double true_values) {
  return interval.lower <= true_values && true_values <= interval.upper;
}

/// The share of `trials` draws of an interval that hold the true objective.
template <class Draw>
double coverage(int trials, double true_values, const Draw& draw) {
  int held = 0;
  for (int i = 0; i < trials; ++i) held += holds(draw(), true_values) ? 1 : 0;
  return static_cast<double>(held) / trials;
}

/// Coverages in several situations.
struct Coverages {
  std::vector<double> all;

  void print(const std::string& what) const {
    std::cout << "coverage of " << what << ": mean " << mean() << ", from " << least() << " to "
              << *std::max_element(all.begin(), all.end()) << '\n';
  }
  double least() const { return *std::min_element(all.begin(), all.end()); }
  double mean() const {
    double sum = 0;
    for (const double x : all) sum += x;
    return sum / static_cast<double>(all.size());
  }
};

double standard_normal(Random& random) {
  return normal(1, random)[0];
}
double exponential(Random& random) {
  return -std::log1p(-uniform(random));
}

TEST(Coverage, OfAShareIsRightOnAverage) {
  for (const int trials : {15, 30, 60, 180}) {
    Coverages coverages;  // exact, from the chance of each count
    for (double p = 0.005; p < 1; p += 0.01) {
      const boost::math::binomial successes(trials, p);
      double held = 0;
      for (int k = 0; k <= trials; ++k) {
        if (holds(wilson_interval(k, trials), p)) held += pdf(successes, k);
      }
      coverages.all.push_back(held);
    }
    coverages.print("Wilson's interval of a share of " + std::to_string(trials));
    EXPECT_NEAR(coverages.mean(), 0.95, 0.01);
    EXPECT_GT(coverages.least(), 0.82);
  }
}

/// Runs of one solver on one problem.
struct Situation {
  std::string name;
  Effort (*run)(double success, Random& random);
  double (*true_values)(double success);  ///< expected running time
};

const std::vector<Situation> situations = {
    // Memoryless, stopped at a budget: a restart neither helps nor harms.
    {"memoryless runs",
     [](double success, Random& random) {
       const double time = exponential(random);
       const double budget = -std::log(1 - success);  // infinite for 1
       return Effort{std::min(time, budget), time <= budget};
     },
     [](double) { return 1.0; }},
    // The same, some of them with thrice the budget of others.
    {"unequal budgets",
     [](double success, Random& random) {
       const double time = exponential(random);
       const double budget = -std::log(1 - success) * (uniform(random) < 0.5 ? 1.6 : 0.5);
       return Effort{std::min(time, budget), time <= budget};
     },
     [](double) { return 1.0; }},
    // A run succeeds by the time 1 to 2, or is stuck until its budget of 10 is gone.
    {"runs that get stuck",
     [](double success, Random& random) {
       const bool reached = uniform(random) < success;
       return Effort{reached ? 1 + uniform(random) : 10, reached};
     },
     [](double success) { return 1.5 + 10 * (1 - success) / success; }},
    // The same with times of a long tail, mean 1.
    {"runs of a long tail",
     [](double success, Random& random) {
       const bool reached = uniform(random) < success;
       return Effort{reached ? std::exp(standard_normal(random) - 0.5) : 10, reached};
     },
     [](double success) { return 1 + 10 * (1 - success) / success; }},
};

TEST(Coverage, OfAnExpectedRunningTimeIsAboutRight) {
  Random random(2);
  for (const int size : {15, 30, 60}) {
    for (const Situation& situation : situations) {
      Coverages coverages;
      for (const double success : {0.2, 0.35, 0.5, 0.65, 0.8, 1.0}) {
        coverages.all.push_back(coverage(500, situation.true_values(success), [&] {
          std::vector<Effort> runs;
          for (int i = 0; i < size; ++i) runs.push_back(situation.run(success, random));
          return expected_running_time_interval(runs);
        }));
      }
      coverages.print("the expected running time of " + std::to_string(size) + " " +
                      situation.name);
      EXPECT_GT(coverages.mean(), 0.93);
      EXPECT_LT(coverages.mean(), 0.975);
    }
  }
}

TEST(Coverage, OfAMeanOfSharesIsAboutRight) {
  Random random(3);
  for (const int size : {12, 30, 60}) {
    Coverages coverages;
    for (const double mean : {0.1, 0.3, 0.5, 0.9}) {
      for (const double spread : {0.2, 0.6, 1.0}) {  // of problems; at 1 each share is 0 or 1
        coverages.all.push_back(coverage(500, mean, [&] {
          std::vector<double> shares;
          for (int i = 0; i < size; ++i) {
            const double easy = uniform(random) < mean ? 1 : 0;
            shares.push_back(spread * easy + (1 - spread) * mean);
          }
          return mean_share(shares).interval;
        }));
      }
    }
    coverages.print("the mean of " + std::to_string(size) + " shares");
    EXPECT_GT(coverages.mean(), 0.93);
    EXPECT_LT(coverages.mean(), 0.97);
  }
}

TEST(Coverage, OfAMeanOfClusteredSharesIsAboutRightOnlyWithTheClusters) {
  Random random(6);
  for (const int size : {6, 12, 30}) {
    Coverages known, ignored;
    for (const double mean : {0.3, 0.5, 0.9}) {
      for (const double spread : {0.4, 1.0}) {  // of the clusters
        std::vector<double> shares;
        std::vector<std::string> clusters;
        const auto draw = [&] {
          shares.clear();
          clusters.clear();
          for (int i = 0; i < size; ++i) {
            const double easy = uniform(random) < mean ? 1 : 0;
            for (std::size_t k = random() % 5 + 1; k > 0; --k) {
              shares.push_back(spread * easy + (1 - spread) * mean);
              clusters.push_back(std::to_string(i));
            }
          }
        };
        known.all.push_back(coverage(500, mean, [&] {
          draw();
          return mean_share(shares, clusters).interval;
        }));
        ignored.all.push_back(coverage(500, mean, [&] {
          draw();
          return mean_share(shares).interval;
        }));
      }
    }
    known.print("the mean of " + std::to_string(size) + " clusters");
    ignored.print("the same without the clusters");
    EXPECT_GT(known.mean(), 0.93);
    EXPECT_LT(ignored.mean(), 0.9);
  }
}

/// Shares of two entries on clusters of four equal problems, and the clusters.
TEST(Coverage, IsMeasuredBySamplesOfTheClusters) {
  Random random(7);
  std::vector<std::vector<double>> entries(2);
  std::vector<std::string> clusters;
  for (int i = 0; i < 15; ++i) {
    const double one = uniform(random), other = uniform(random) < 0.5 ? 1 : 0;
    for (int k = 0; k < 4; ++k) {
      entries[0].push_back(one);
      entries[1].push_back(other);
      clusters.push_back(std::to_string(i));
    }
  }
  EXPECT_GT(coverage_of_mean_share(entries, clusters, true, 1, 400), 0.92);
  EXPECT_LT(coverage_of_mean_share(entries, clusters, false, 1, 400), 0.8);
  EXPECT_EQ(coverage_of_mean_share(entries, clusters, true, 1),
            coverage_of_mean_share(entries, clusters, true, 1));
}

TEST(Coverage, OfKendallsCorrelationIsAboutRight) {
  Random random(4);
  for (const int alike : {1, 3}) {  // pairs of one solver
    Coverages coverages;
    for (const double true_values : {0.0, 0.3, 0.6, 0.8}) {
      const double pearson =
          std::sin(std::acos(-1.0) / 2 * true_values);  // of normal pairs (Greiner 1909)
      coverages.all.push_back(coverage(400, true_values, [&] {
        std::vector<double> a;
        std::vector<double> b;
        std::vector<std::string> solvers;
        const auto add = [&](const Vector& x) {
          a.push_back(x[0]);
          b.push_back(pearson * x[0] + std::sqrt(1 - pearson * pearson) * x[1]);
        };
        for (int solver = 0; solver < 12; ++solver) {
          const Vector common = normal(2, random);
          for (int k = 0; k < alike; ++k) {
            const Vector own = normal(2, random);
            add(std::sqrt(0.7) * common + std::sqrt(0.3) * own);
            solvers.push_back(std::to_string(solver));
          }
        }
        return *kendall_interval(a, b, solvers, 1, 0.95, 500);
      }));
    }
    coverages.print("Kendall's correlation of 12 solvers with " + std::to_string(alike) +
                    " entries each");
    EXPECT_GT(coverages.mean(), 0.92);
    EXPECT_LT(coverages.mean(), 0.98);
  }
}

}  // namespace
}  // namespace ricochet
