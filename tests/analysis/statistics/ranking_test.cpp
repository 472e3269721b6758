#include "src/analysis/statistics/ranking.h"

#include "ricochet/random.h"
#include "tests/support/numbers.h"
#include "tests/support/test.h"

namespace ricochet {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Ranks, AreSharedByEqualValues) {
  EXPECT_THAT(ranks_of({3, 1, 3, infinity, 3, infinity}), ElementsAre(3, 1, 3, 5.5, 3, 5.5));
  EXPECT_THAT(ranks_of({}), IsEmpty());
}

TEST(Ranking, IsByTheValueAndThenByTheCost) {
  EXPECT_THAT(ranking_of({Reached{7, 50}, Reached{6, 900}, Reached{7, 40}, Reached{8, 1}}),
              ElementsAre(ElementsAre(1), ElementsAre(2), ElementsAre(0), ElementsAre(3)));
  // Ties stay together, and who did not take part is left out.
  const Reached nothing{infinity, infinity};
  EXPECT_THAT(ranking_of({nothing, Reached{7, 40}, std::nullopt, Reached{7, 40}, nothing}),
              ElementsAre(ElementsAre(1, 3), ElementsAre(0, 4)));
  EXPECT_THAT(ranking_of({std::nullopt}), IsEmpty());
}

TEST(RankCorrelation, OfKendallIsWhatThePairsByHandGive) {
  EXPECT_EQ(kendall_rank_correlation({1, 2, 3, 10}, {0.1, 0.2, 5, 6}), 1.0);
  EXPECT_EQ(kendall_rank_correlation({1, 2, 3, 10}, {6, 5, 0.2, 0.1}), -1.0);
  EXPECT_DOUBLE_EQ(*kendall_rank_correlation({1, 2, 3, 4}, {1, 3, 2, 4}), (5.0 - 1) / 6);
  // Five pairs of six are untied in the first, all in the second.
  EXPECT_DOUBLE_EQ(*kendall_rank_correlation({1, 2, 2, 4}, {1, 2, 3, 4}), 5 / std::sqrt(5.0 * 6));
  EXPECT_DOUBLE_EQ(*kendall_rank_correlation({1, 2, 3, 4}, {1, 2, 2, 4}), 5 / std::sqrt(6 * 5.0));
  EXPECT_DOUBLE_EQ(*kendall_rank_correlation({1, 2, 2, 4}, {1, 2, 2, 4}), 1);
  EXPECT_FALSE(kendall_rank_correlation({1, 1, 1}, {1, 2, 3}));
}

/// Kendall's tau-b by its definition, or nothing.
std::optional<double> tau(const std::vector<double>& a, const std::vector<double>& b) {
  double difference = 0, unlike_a = 0, unlike_b = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = i + 1; k < a.size(); ++k) {
      const double product = (a[i] - a[k]) * (b[i] - b[k]);
      difference += product > 0 ? 1 : product < 0 ? -1 : 0;
      unlike_a += a[i] != a[k] ? 1 : 0;
      unlike_b += b[i] != b[k] ? 1 : 0;
    }
  }
  if (unlike_a * unlike_b == 0) return std::nullopt;
  return difference / std::sqrt(unlike_a * unlike_b);
}

TEST(RankCorrelation, OfKendallHasTheIntervalOfAllSamplesOfClusters) {
  const std::vector<double> a = {1, 2, 3, 4, 5, 6, 7, 8};
  const std::vector<double> b = {2, 1, 5, 4, 4, 8, 6, 7};
  const std::vector<std::string> clusters = {"p", "q", "q", "r", "s", "s", "t", "p"};
  EXPECT_EQ(kendall_rank_correlation(a, b), tau(a, b));
  std::vector<double> all;
  for (int code = 0; code < 3125; ++code) {  // five clusters drawn from five
    std::vector<double> drawn_a, drawn_b;
    for (int draw = 0, rest = code; draw < 5; ++draw, rest /= 5) {
      for (std::size_t i = 0; i < a.size(); ++i) {
        if (clusters[i][0] != 'p' + rest % 5) continue;
        drawn_a.push_back(a[i]);
        drawn_b.push_back(b[i]);
      }
    }
    if (const auto one = tau(drawn_a, drawn_b)) all.push_back(*one);
  }
  std::sort(all.begin(), all.end());
  const auto at = [&](double q) {
    return all[static_cast<std::size_t>(q * static_cast<double>(all.size()))];
  };
  const auto interval = kendall_interval(a, b, clusters, 1, 0.9, 20000);
  ASSERT_TRUE(interval);
  EXPECT_NEAR(interval->lower, at(0.05), 0.02);
  EXPECT_NEAR(interval->upper, at(0.95), 0.02);
  EXPECT_LT(interval->lower, interval->upper);
}

TEST(RankCorrelation, OfKendallHasNoIntervalForFewClusters) {
  const std::vector<double> rising = {1, 2, 3, 4, 5};
  EXPECT_EQ(kendall_interval(rising, rising, {"a", "b", "c", "d", "e"}, 1)->lower, 1);
  EXPECT_FALSE(kendall_interval(rising, rising, {"a", "b", "c", "d", "a"}, 1));
  EXPECT_FALSE(kendall_interval({1, 1, 1, 1, 1}, rising, {"a", "b", "c", "d", "e"}, 1));
}

TEST(RivalsAhead, AreCountedPairByPair) {
  Random random(1);
  for (int trial = 0; trial < 50; ++trial) {
    constexpr std::size_t size = 7;
    std::vector<std::optional<Reached>> reached(size);
    for (std::size_t e = 0; e < size; ++e) {
      const double value = static_cast<int>(4 * uniform(random));  // often tied
      if (e != 3) reached[e] = Reached{value, 1};
    }
    const RivalsAhead ahead = rivals_ahead({ranking_of(reached)});
    ASSERT_EQ(ahead.entries, (std::vector<std::size_t>{0, 1, 2, 4, 5, 6}));
    for (std::size_t k = 0; k < ahead.entries.size(); ++k) {
      const double mine = reached[ahead.entries[k]]->value;
      double before = 0;
      for (const std::size_t other : ahead.entries) {
        if (other == ahead.entries[k]) continue;
        const double its = reached[other]->value;
        before += its < mine ? 1 : its == mine ? 0.5 : 0;
      }
      EXPECT_DOUBLE_EQ(ahead.of_instance[0][k], before / 5);
    }
  }
}

TEST(RivalsAhead, HaveAMeanOverInstancesThenOverProblems) {
  const RivalsAhead both = rivals_ahead({{{0}, {1}}, {{0}, {1}}, {{1}, {0}}});
  const RivalsAhead others = rivals_ahead({{{2}, {1}, {0}}});
  const auto means = mean_rivals_ahead({both, others}, 4);
  EXPECT_NEAR(*means[0], (1.0 / 3 + 1) / 2, 1e-12);
  EXPECT_NEAR(*means[1], (2.0 / 3 + 0.5) / 2, 1e-12);
  EXPECT_EQ(means[2], 0.0);
  EXPECT_FALSE(means[3]);
  EXPECT_EQ(first_of(means), (std::vector<std::size_t>{2}));
  EXPECT_EQ(first_of({std::nullopt, 0.5, 0.25, 0.25}), (std::vector<std::size_t>{2, 3}));
  EXPECT_TRUE(first_of({std::nullopt}).empty());
}

TEST(RivalsAhead, AreNobodysIfOneEntryIsAlone) {
  EXPECT_TRUE(rivals_ahead({{{5}}}).entries.empty());
  EXPECT_TRUE(rivals_ahead({{}}).of_instance.empty());
}

TEST(Ranking, RefusesWhatDoesNotFit) {
  EXPECT_THROW(ranks_of({1, std::nan("")}), std::invalid_argument);
  EXPECT_THROW(ranking_of({Reached{std::nan(""), 1}}), std::invalid_argument);
  EXPECT_THROW(ranking_of({Reached{1, std::nan("")}}), std::invalid_argument);
  EXPECT_THROW(kendall_rank_correlation({1, 2}, {1, 2, 3}), std::invalid_argument);
  EXPECT_THROW(kendall_rank_correlation({1}, {1}), std::invalid_argument);
  EXPECT_THROW(kendall_interval({1, 2, 3, 4, 5}, {1, 2, 3, 4, 5}, {"a"}, 1), std::invalid_argument);
  EXPECT_THROW(rivals_ahead({{{0}, {1}}, {{0}, {2}}}), std::invalid_argument);
  EXPECT_THROW(probabilities_of_being_first({rivals_ahead({{{0}, {1}}})}, 3, 1),
               std::invalid_argument);
}

/// Entry 2 takes the first problem only.
std::vector<RivalsAhead> two_problems() {
  return {rivals_ahead({{{0}, {2}, {1}}, {{1}, {2}, {0}}}), rivals_ahead({{{1}, {0}}, {{0, 1}}})};
}

/// All equally likely samples of two problems, with two instances of each, one after the other.
std::vector<double> enumerated(const std::vector<RivalsAhead>& problems) {
  std::vector<RivalsAhead> draws;
  for (const RivalsAhead& problem : problems) {
    for (const std::vector<double>& one : problem.of_instance) {
      for (const std::vector<double>& other : problem.of_instance) {
        draws.push_back({"", problem.entries, {one, other}});
      }
    }
  }
  std::vector<double> shares(3);
  for (const RivalsAhead& a : draws) {
    for (const RivalsAhead& b : draws) {
      const std::vector<std::size_t> first = first_of(mean_rivals_ahead({a, b}, 3));
      for (const std::size_t e : first) shares[e] += 1 / static_cast<double>(first.size()) / 64;
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
  EXPECT_EQ(probabilities_of_being_first(problems, 3, 1, 40000), drawn);
  EXPECT_NE(probabilities_of_being_first(problems, 3, 2, 40000), drawn) << "another seed";
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

constexpr std::size_t noisy_entries = 6;

/// Problems on which the entries come in an order that chance disturbs.
std::vector<RivalsAhead> noisy_problems(std::size_t number, double noise) {
  Random random(7);
  std::vector<RivalsAhead> problems;
  for (std::size_t q = 0; q < number; ++q) {
    std::vector<Ranking> instances;
    for (int i = 0; i < 3; ++i) {
      std::vector<std::optional<Reached>> reached;
      for (std::size_t e = 0; e < noisy_entries; ++e) {
        const double value = static_cast<double>(e) + noise * normal(1, random)[0];
        reached.push_back(Reached{std::round(value), 0});
      }
      instances.push_back(ranking_of(reached));
    }
    problems.push_back(rivals_ahead(instances));
  }
  return problems;
}

std::vector<RivalsAhead> chosen(const std::vector<RivalsAhead>& problems,
                                const std::vector<std::size_t>& places) {
  std::vector<RivalsAhead> some;
  for (const std::size_t q : places) some.push_back(problems[q]);
  return some;
}

TEST(HeldOutOrder, IsTheMeanOverAllHalves) {
  for (const std::size_t number : {4U, 5U, 6U}) {
    const auto problems = noisy_problems(number, 2.5);
    const std::size_t half = number / 2;
    double sum = 0, stays = 0, splits = 0;
    // Each problem is in the first half (0), in the second (1) or left out (2).
    for (int code = 0; code < std::pow(3, number); ++code) {
      std::vector<std::vector<std::size_t>> parts(3);
      for (std::size_t q = 0, rest = static_cast<std::size_t>(code); q < number; ++q, rest /= 3) {
        parts[rest % 3].push_back(q);
      }
      if (parts[0].size() != half || parts[1].size() != half) continue;
      std::vector<std::vector<double>> means;
      std::vector<std::set<std::size_t>> firsts;
      for (int half_of : {0, 1}) {
        const auto own = mean_rivals_ahead(chosen(problems, parts[half_of]), noisy_entries);
        means.emplace_back();
        for (const auto& mean : own) means.back().push_back(*mean);
        const auto first = first_of(own);
        firsts.emplace_back(first.begin(), first.end());
      }
      sum += *tau(means[0], means[1]);
      double same = 0;
      for (const std::size_t e : firsts[0]) same += firsts[1].contains(e) ? 1 : 0;
      stays += same / static_cast<double>(firsts[0].size() * firsts[1].size());
      ++splits;
    }
    const auto order = held_out_order(problems, noisy_entries, 1, 20000);
    ASSERT_TRUE(order);
    EXPECT_NEAR(order->correlation, sum / splits, 0.01) << number;
    EXPECT_NEAR(order->first_stays, stays / splits, 0.01) << number;
    EXPECT_LE(order->interval.lower, order->correlation);
    EXPECT_GE(order->interval.upper, order->correlation);
  }
}

TEST(HeldOutOrder, HoldsClustersOutWhole) {
  // Both problems of a cluster agree, and clusters disagree: halves of problems would share them.
  std::vector<RivalsAhead> problems;
  for (const RivalsAhead& problem : noisy_problems(8, 3)) {
    for (int copy = 0; copy < 2; ++copy) {
      problems.push_back(problem);
      problems.back().cluster = std::to_string(problems.size() / 2 + problems.size() % 2);
    }
  }
  const auto whole = held_out_order(problems, noisy_entries, 1, 4000);
  EXPECT_NEAR(whole->correlation,
              held_out_order(noisy_problems(8, 3), noisy_entries, 1, 4000)->correlation, 0.02);
  for (RivalsAhead& problem : problems) problem.cluster.clear();
  EXPECT_GT(held_out_order(problems, noisy_entries, 1, 4000)->correlation,
            whole->correlation + 0.05);
}

TEST(HeldOutOrder, IsNothingForFewProblemsOrEntries) {
  EXPECT_FALSE(held_out_order(noisy_problems(3, 1), noisy_entries, 1));
  std::vector<RivalsAhead> two = noisy_problems(8, 1);
  for (std::size_t k = 0; k < two.size(); ++k) two[k].cluster = k < 4 ? "a" : "b";
  EXPECT_FALSE(held_out_order(two, noisy_entries, 1));
  const std::vector<RivalsAhead> four(6, rivals_ahead({{{0}, {1}, {2}, {3}}}));
  EXPECT_FALSE(held_out_order(four, 4, 1));
  const std::vector<RivalsAhead> tied(6, rivals_ahead({{{0, 1, 2, 3, 4, 5}}}));
  EXPECT_FALSE(held_out_order(tied, noisy_entries, 1));
}

}  // namespace
}  // namespace ricochet
