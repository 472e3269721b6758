#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

#include "src/analysis/statistics/ranking.h"

namespace ricochet {
namespace {

/// Entry 2 takes the first problem only.
std::vector<RivalsAhead> two_problems() {
  return {rivals_ahead({{{0}, {2}, {1}}, {{1}, {2}, {0}}}), rivals_ahead({{{1}, {0}}, {{0, 1}}})};
}

/// All equally likely samples of two problems, with two instances of each, one after the other.
std::array<double, 3> enumerated(const std::vector<RivalsAhead>& problems) {
  struct Draw {
    std::size_t problem, one, other;
  };
  std::vector<Draw> draws;
  for (std::size_t q = 0; q < 2; ++q) {
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t k = 0; k < 2; ++k) draws.push_back({q, i, k});
    }
  }
  std::array<double, 3> shares{};
  for (const Draw& a : draws) {
    for (const Draw& b : draws) {
      std::array<double, 3> means;
      for (std::size_t e = 0; e < 3; ++e) {
        double sum = 0;
        int taken = 0;
        for (const Draw& draw : {a, b}) {
          const RivalsAhead& problem = problems[draw.problem];
          const auto at = std::find(problem.entries.begin(), problem.entries.end(), e);
          if (at == problem.entries.end()) continue;
          const auto k = static_cast<std::size_t>(at - problem.entries.begin());
          sum += (problem.of_instance[draw.one][k] + problem.of_instance[draw.other][k]) / 2;
          ++taken;
        }
        means[e] = taken == 0 ? std::numeric_limits<double>::infinity() : sum / taken;
      }
      const double least = *std::min_element(means.begin(), means.end());
      const auto tied = std::count(means.begin(), means.end(), least);
      for (std::size_t e = 0; e < 3; ++e) {
        if (means[e] == least) shares[e] += 1 / static_cast<double>(tied) / 64;
      }
    }
  }
  return shares;
}

TEST(ProbabilityOfBeingFirst, IsThatOfAllSamplesOfProblemsAndInstances) {
  const auto problems = two_problems();
  const auto exact = enumerated(problems);
  const auto drawn = probabilities_of_being_first(problems, 3, 1, 40000);
  double sum = 0;
  for (std::size_t e = 0; e < 3; ++e) {
    EXPECT_NEAR(drawn[e], exact[e], 0.01) << e;
    EXPECT_GT(exact[e], 0.05) << e;
    sum += drawn[e];
  }
  EXPECT_NEAR(sum, 1, 1e-9);
}

TEST(ProbabilityOfBeingFirst, DoesNotGrowWithTheInstancesOfFewProblems) {
  const std::vector<Ranking> one(50, {{0}, {1}});
  const std::vector<Ranking> other(50, {{1}, {0}});
  const std::vector<RivalsAhead> problems = {rivals_ahead(one), rivals_ahead(one),
                                             rivals_ahead(other)};
  // More ones than others among three draws: 20 of 27.
  EXPECT_NEAR(probabilities_of_being_first(problems, 2, 3, 20000)[0], 20.0 / 27, 0.01);
}

TEST(ProbabilityOfBeingFirst, DoesNotGrowWithTheProblemsOfFewClusters) {
  std::vector<RivalsAhead> problems;
  for (int copy = 0; copy < 10; ++copy) {
    for (const char* cluster : {"a", "b", "c"}) {
      problems.push_back(rivals_ahead({*cluster == 'c' ? Ranking{{1}, {0}} : Ranking{{0}, {1}}}));
      problems.back().cluster = cluster;
    }
  }
  EXPECT_NEAR(probabilities_of_being_first(problems, 2, 3, 20000)[0], 20.0 / 27, 0.01);
  for (RivalsAhead& problem : problems) problem.cluster.clear();
  EXPECT_GT(probabilities_of_being_first(problems, 2, 3, 20000)[0], 0.95);
  for (RivalsAhead& problem : problems) problem.cluster = "one";
  EXPECT_THROW(probabilities_of_being_first(problems, 2, 3), std::invalid_argument);
}

TEST(ProbabilityOfBeingFirst, IsSharedByEquals) {
  const std::vector<RivalsAhead> problems(3, rivals_ahead({{{0, 1}}}));
  EXPECT_NEAR(probabilities_of_being_first(problems, 2, 1)[0], 0.5, 1e-9);
}

TEST(ProbabilityOfBeingFirst, IsDeterministicAndNeedsTwoProblems) {
  const auto problems = two_problems();
  EXPECT_EQ(probabilities_of_being_first(problems, 3, 1),
            probabilities_of_being_first(problems, 3, 1));
  EXPECT_NE(probabilities_of_being_first(problems, 3, 1),
            probabilities_of_being_first(problems, 3, 2));
  EXPECT_THROW(probabilities_of_being_first({problems[0]}, 3, 1), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
