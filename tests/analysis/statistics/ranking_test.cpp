#include "src/analysis/statistics/ranking.h"

#include "ricochet/random.h"
#include "tests/support/numbers.h"
#include "tests/support/test.h"

namespace ricochet {
namespace {

TEST(Ranking, IsByTheValueAndThenByTheCost) {
  EXPECT_THAT(ranks_of({3, 1, 3, infinity, 3, infinity}), ElementsAre(3, 1, 3, 5.5, 3, 5.5));
  EXPECT_THAT(ranks_of({}), IsEmpty());
  EXPECT_THAT(ranking_of({Reached{7, 50}, Reached{6, 900}, Reached{7, 40}, Reached{8, 1}}),
              ElementsAre(ElementsAre(1), ElementsAre(2), ElementsAre(0), ElementsAre(3)));
  // Ties stay together, and who did not take part is left out.
  const Reached nothing{infinity, infinity};
  EXPECT_THAT(ranking_of({nothing, Reached{7, 40}, std::nullopt, Reached{7, 40}, nothing}),
              ElementsAre(ElementsAre(1, 3), ElementsAre(0, 4)));
  EXPECT_THAT(ranking_of({std::nullopt}), IsEmpty());
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

TEST(RankCorrelation, OfKendallIsThatOfAllPairsWithTheIntervalOfAllSamplesOfClusters) {
  const std::vector<double> a = {1, 2, 3, 4, 5, 6, 7, 8}, b = {2, 1, 5, 4, 4, 8, 6, 7};
  const std::vector<std::string> clusters = {"p", "q", "q", "r", "s", "s", "t", "p"};
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
    const auto one = tau(drawn_a, drawn_b), told = kendall_rank_correlation(drawn_a, drawn_b);
    ASSERT_EQ(told.has_value(), one.has_value());
    if (!one) continue;
    EXPECT_NEAR(*told, *one, 1e-12);
    all.push_back(*one);
  }
  const auto interval = kendall_interval(a, b, clusters, 1, 0.9, 20000);
  ASSERT_TRUE(interval);
  EXPECT_NEAR(interval->lower, quantile(all, 0.05), 0.02);
  EXPECT_NEAR(interval->upper, quantile(all, 0.95), 0.02);
  EXPECT_LT(interval->lower, interval->upper);
  const std::vector<double> rising = {1, 2, 3, 4, 5};
  EXPECT_EQ(kendall_interval(rising, rising, {"a", "b", "c", "d", "e"}, 1)->lower, 1);
  EXPECT_FALSE(kendall_interval(rising, rising, {"a", "b", "c", "d", "a"}, 1)) << "few clusters";
  EXPECT_FALSE(kendall_interval({1, 1, 1, 1, 1}, rising, {"a", "b", "c", "d", "e"}, 1));
}

TEST(RivalsAhead, AreCountedPairByPair) {
  Random random(1);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<std::optional<Reached>> reached(7);
    for (auto& own : reached) own = Reached{std::floor(4 * uniform(random)), 1};  // often tied
    reached[3].reset();
    const RivalsAhead ahead = rivals_ahead({ranking_of(reached)});
    ASSERT_THAT(ahead.entries, ElementsAre(0, 1, 2, 4, 5, 6));
    for (std::size_t k = 0; k < 6; ++k) {
      const double mine = reached[ahead.entries[k]]->value;
      double before = -0.5;  // it is tied with itself
      for (const auto& other : reached) {
        if (other) before += other->value < mine ? 1 : other->value == mine ? 0.5 : 0;
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
  EXPECT_THAT(first_of(means), ElementsAre(2));
  EXPECT_THAT(first_of({std::nullopt, 0.5, 0.25, 0.25}), ElementsAre(2, 3));
  EXPECT_THAT(first_of({std::nullopt}), IsEmpty());
  EXPECT_TRUE(rivals_ahead({{{5}}}).entries.empty()) << "it is alone";
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

TEST(ProbabilityOfBeingFirst, IsThatOfAllSamplesOfProblemsAndInstances) {
  // Entry 2 takes the first problem only.
  const std::vector<RivalsAhead> problems = {rivals_ahead({{{0}, {2}, {1}}, {{1}, {2}, {0}}}),
                                             rivals_ahead({{{1}, {0}}, {{0, 1}}})};
  // All equally likely draws of a problem and of two of its instances, one after the other.
  std::vector<RivalsAhead> draws;
  for (const RivalsAhead& problem : problems) {
    for (const std::vector<double>& one : problem.of_instance) {
      for (const std::vector<double>& other : problem.of_instance) {
        draws.push_back({"", problem.entries, {one, other}});
      }
    }
  }
  std::vector<double> exact(3);
  for (const RivalsAhead& a : draws) {
    for (const RivalsAhead& b : draws) {
      const std::vector<std::size_t> first = first_of(mean_rivals_ahead({a, b}, 3));
      for (const std::size_t e : first) exact[e] += 1 / static_cast<double>(first.size()) / 64;
    }
  }
  const auto near = [](double share) { return testing::DoubleNear(share, 0.01); };
  const auto drawn = probabilities_of_being_first(problems, 3, 1, 40000);
  EXPECT_THAT(drawn, ElementsAre(near(exact[0]), near(exact[1]), near(exact[2])));
  EXPECT_NEAR(drawn[0] + drawn[1] + drawn[2], 1, 1e-9);
  EXPECT_THAT(exact, Each(testing::Gt(0.05)));
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

TEST(HeldOutOrder, IsTheMeanOverAllHalves) {
  for (const std::size_t number : {4U, 5U, 8U}) {
    const auto problems = noisy_problems(number, 2.5);
    std::vector<double> correlations;
    const std::size_t half = number / 2;
    double sum = 0, stays = 0, splits = 0;
    // Each problem is in the first half (0), in the second (1) or left out (2).
    for (int code = 0; code < std::pow(3, number); ++code) {
      std::vector<std::vector<RivalsAhead>> parts(3);
      int rest = code;
      for (const RivalsAhead& problem : problems) {
        parts[static_cast<std::size_t>(rest % 3)].push_back(problem);
        rest /= 3;
      }
      if (parts[0].size() != half || parts[1].size() != half) continue;
      std::array<std::vector<double>, 2> means;
      std::array<std::vector<std::size_t>, 2> firsts;
      for (const std::size_t part : {0U, 1U}) {
        const auto own = mean_rivals_ahead(parts[part], noisy_entries);
        for (const auto& mean : own) means[part].push_back(*mean);
        firsts[part] = first_of(own);
      }
      sum += correlations.emplace_back(*tau(means[0], means[1]));
      std::vector<std::size_t> both;
      std::ranges::set_intersection(firsts[0], firsts[1], std::back_inserter(both));
      stays += static_cast<double>(both.size()) /
               static_cast<double>(firsts[0].size() * firsts[1].size());
      ++splits;
    }
    const auto order = held_out_order(problems, noisy_entries, 1, 20000);
    ASSERT_TRUE(order);
    EXPECT_NEAR(order->correlation, sum / splits, 0.01) << number;
    EXPECT_NEAR(order->first_stays, stays / splits, 0.01) << number;
    // Beyond each end lie 2.5 % of all halves, as far as 20,000 drawn ones say.
    const auto share = [&](auto is_there) {
      return static_cast<double>(std::ranges::count_if(correlations, is_there)) / splits;
    };
    const auto [lower, upper] = order->interval;
    EXPECT_LT(share([l = lower](double c) { return c < l; }), 0.028);
    EXPECT_GT(share([l = lower](double c) { return c <= l; }), 0.022);
    EXPECT_LT(share([u = upper](double c) { return c > u; }), 0.028);
    EXPECT_GT(share([u = upper](double c) { return c >= u; }), 0.022);
  }
}

TEST(HeldOutOrder, HoldsClustersOutWhole) {
  // Both problems of a cluster agree, and clusters disagree: halves of problems would share them.
  const auto correlation = [](const std::vector<RivalsAhead>& problems) {
    return held_out_order(problems, noisy_entries, 1, 4000)->correlation;
  };
  const std::vector<RivalsAhead> single = noisy_problems(8, 3);
  std::vector<RivalsAhead> twice;
  for (RivalsAhead problem : single) {
    problem.cluster = std::to_string(twice.size());
    twice.insert(twice.end(), 2, problem);
  }
  const double whole = correlation(twice);
  EXPECT_NEAR(whole, correlation(single), 0.02);
  for (RivalsAhead& problem : twice) problem.cluster.clear();
  EXPECT_GT(correlation(twice), whole + 0.05);
}

TEST(HeldOutOrder, IsNothingForFewProblemsOrEntries) {
  EXPECT_FALSE(held_out_order(noisy_problems(3, 1), noisy_entries, 1));
  std::vector<RivalsAhead> two = noisy_problems(8, 1);
  for (std::size_t k = 0; k < two.size(); ++k) two[k].cluster = k < 4 ? "a" : "b";
  EXPECT_FALSE(held_out_order(two, noisy_entries, 1)) << "two clusters";
  const std::vector<RivalsAhead> four(6, rivals_ahead({{{0}, {1}, {2}, {3}}}));
  EXPECT_FALSE(held_out_order(four, 4, 1));
  const std::vector<RivalsAhead> tied(6, rivals_ahead({{{0, 1, 2, 3, 4, 5}}}));
  EXPECT_FALSE(held_out_order(tied, noisy_entries, 1));
}

}  // namespace
}  // namespace ricochet
