#include "ricochet/random.h"
#include "src/analysis/statistics/intervals.h"
#include "src/analysis/statistics/ranking.h"
#include "src/analysis/statistics/running_time.h"
#include "tests/support/test.h"

/// How often each interval of 95 % holds the true value, where the true value is known.
namespace ricochet {
namespace {

/// The share of `trials` draws of an interval that hold the truth.
template <class Draw>
double coverage(int trials, double truth, const Draw& draw) {
  int held = 0;
  for (int i = 0; i < trials; ++i) {
    const Interval interval = draw();
    held += interval.lower <= truth && truth <= interval.upper ? 1 : 0;
  }
  return static_cast<double>(held) / trials;
}

double mean_of(const std::vector<double>& coverages) {
  return std::accumulate(coverages.begin(), coverages.end(), 0.0) /
         static_cast<double>(coverages.size());
}

/// Runs of one solver on one problem.
struct Situation {
  Effort (*run)(double success, Random& random);
  double (*expected)(double success);  ///< running time
};

/// A memoryless run, stopped at a budget, so many times that of the chance given: a restart neither
/// helps nor harms.
Effort memoryless(double success, double times, Random& random) {
  const double time = -std::log1p(-uniform(random));     // exponential
  const double budget = -std::log(1 - success) * times;  // infinite for 1
  return {std::min(time, budget), time <= budget};
}

const std::vector<Situation> situations = {
    {[](double success, Random& random) { return memoryless(success, 1, random); },
     [](double) { return 1.0; }},
    // Some of them with thrice the budget of others.
    {[](double success, Random& random) {
       return memoryless(success, uniform(random) < 0.5 ? 1.6 : 0.5, random);
     },
     [](double) { return 1.0; }},
    // A run succeeds by the time 1 to 2, or is stuck until its budget of 10 is gone.
    {[](double success, Random& random) {
       const bool reached = uniform(random) < success;
       return Effort{reached ? 1 + uniform(random) : 10, reached};
     },
     [](double success) { return 1.5 + 10 * (1 - success) / success; }},
    // The same with times of a long tail, mean 1.
    {[](double success, Random& random) {
       const bool reached = uniform(random) < success;
       return Effort{reached ? std::exp(normal(1, random)[0] - 0.5) : 10, reached};
     },
     [](double success) { return 1 + 10 * (1 - success) / success; }},
};

TEST(Coverage, OfAnExpectedRunningTimeIsAboutRight) {
  Random random(2);
  for (const int size : {15, 30, 60}) {
    for (const Situation& situation : situations) {
      std::vector<double> coverages;
      for (const double success : {0.2, 0.35, 0.5, 0.65, 0.8, 1.0}) {
        coverages.push_back(coverage(500, situation.expected(success), [&] {
          std::vector<Effort> runs;
          for (int i = 0; i < size; ++i) runs.push_back(situation.run(success, random));
          return expected_running_time_interval(runs);
        }));
      }
      EXPECT_GT(mean_of(coverages), 0.93) << size << " runs of " << &situation - &situations[0];
      EXPECT_LT(mean_of(coverages), 0.975) << size << " runs of " << &situation - &situations[0];
    }
  }
}

TEST(Coverage, OfAMeanOfSharesIsAboutRightIfClustersAreKnown) {
  Random random(3);
  // Of so many clusters of up to so many equal problems: a share is easy with the chance `mean`,
  // and at a spread of 1 either 0 or 1.
  const auto mean_coverage = [&](int size, std::size_t alike, bool known) {
    std::vector<double> coverages;
    for (const double mean : {0.1, 0.3, 0.5, 0.9}) {
      if (alike > 1 && mean == 0.1) continue;
      for (const double spread : {0.2, 0.6, 1.0}) {
        coverages.push_back(coverage(500, mean, [&] {
          std::vector<double> shares;
          std::vector<std::string> clusters;
          for (int i = 0; i < size; ++i) {
            const double easy = uniform(random) < mean ? 1 : 0;
            const std::size_t problems = alike == 1 ? 1 : random() % alike + 1;
            shares.insert(shares.end(), problems, spread * easy + (1 - spread) * mean);
            if (known) clusters.insert(clusters.end(), problems, std::to_string(i));
          }
          return mean_share(shares, clusters).interval;
        }));
      }
    }
    return mean_of(coverages);
  };
  for (const int size : {12, 30, 60})
    EXPECT_NEAR(mean_coverage(size, 1, false), 0.95, 0.02) << size;
  for (const int size : {6, 12, 30}) {
    EXPECT_GT(mean_coverage(size, 5, true), 0.93) << size;
    EXPECT_LT(mean_coverage(size, 5, false), 0.9) << size;
  }
}

TEST(Coverage, IsMeasuredBySamplesOfTheClusters) {
  Random random(7);
  std::vector<std::vector<double>> entries(2);  // their shares on clusters of four equal problems
  std::vector<std::string> clusters;
  for (int i = 0; i < 15; ++i) {
    clusters.insert(clusters.end(), 4, std::to_string(i));
    entries[0].insert(entries[0].end(), 4, uniform(random));
    entries[1].insert(entries[1].end(), 4, uniform(random) < 0.5 ? 1 : 0);
  }
  EXPECT_GT(coverage_of_mean_share(entries, clusters, true, 1, 400), 0.92);
  EXPECT_LT(coverage_of_mean_share(entries, clusters, false, 1, 400), 0.8);
}

TEST(Coverage, OfKendallsCorrelationIsAboutRight) {
  Random random(4);
  for (const int alike : {1, 3}) {  // pairs of one solver
    std::vector<double> coverages;
    for (const double truth : {0.0, 0.3, 0.6, 0.8}) {
      const double pearson = std::sin(std::numbers::pi / 2 * truth);  // Greiner 1909
      coverages.push_back(coverage(400, truth, [&] {
        std::vector<double> a, b;
        std::vector<std::string> solvers;
        for (int solver = 0; solver < 12; ++solver) {
          const Vector common = normal(2, random);
          for (int k = 0; k < alike; ++k) {
            const Vector x = std::sqrt(0.7) * common + std::sqrt(0.3) * normal(2, random);
            a.push_back(x[0]);
            b.push_back(pearson * x[0] + std::sqrt(1 - pearson * pearson) * x[1]);
            solvers.push_back(std::to_string(solver));
          }
        }
        return *kendall_interval(a, b, solvers, 1, 0.95, 500);
      }));
    }
    EXPECT_NEAR(mean_of(coverages), 0.95, 0.03) << alike;
  }
}

}  // namespace
}  // namespace ricochet
