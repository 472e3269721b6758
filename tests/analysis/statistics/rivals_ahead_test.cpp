#include <gtest/gtest.h>

#include <stdexcept>

#include "ricochet/random.h"
#include "src/analysis/statistics/ranking.h"

namespace ricochet {
namespace {

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

TEST(RivalsAhead, RefuseInstancesOfDifferentEntries) {
  EXPECT_THROW(rivals_ahead({{{0}, {1}}, {{0}, {2}}}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
