#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "src/experiment/store.h"
#include "tests/support/numbers.h"

namespace ricochet {

inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// Any bits that a number can have, and often those that are lost first.
inline double any_number(std::mt19937_64& random) {
  const double lost_first[] = {0.0,       -0.0, infinity, -infinity, std::nan(""), -std::nan("7"),
                               -0x1.p+63, 1e18, 3.0,      5e-324};
  const std::uint64_t bits = random();
  return bits % 2 == 0 ? lost_first[random() % std::size(lost_first)] : std::bit_cast<double>(bits);
}

inline std::int64_t any_count(std::mt19937_64& random) {
  return static_cast<std::int64_t>(random() >> (1 + random() % 63));
}

inline double any_time(std::mt19937_64& random) {
  const double seconds = any_number(random);
  return std::isfinite(seconds) && !std::signbit(seconds) ? seconds : 0.25;
}

inline Vector any_point(std::mt19937_64& random) {
  Vector x(static_cast<Eigen::Index>(random() % 5));
  for (double& coordinate : x) coordinate = any_number(random);
  return x;
}

inline TrueValues any_true_values(std::mt19937_64& random) {
  const double objective = any_number(random);
  return {objective, std::abs(any_number(random))};
}

/// A trace in which every step improves the one before.
inline std::vector<Improvement> any_trace(std::mt19937_64& random, std::int64_t charged) {
  std::vector<Improvement> trace;
  for (auto left = random() % 4; left > 0; --left) {
    const auto evaluations =
        static_cast<std::int64_t>(random() % (static_cast<std::uint64_t>(charged) + 1));
    const TrueValues reached = any_true_values(random);
    if (std::isnan(reached.objective) || std::isnan(reached.violation)) continue;
    trace.push_back({evaluations, any_time(random), reached, any_point(random)});
  }
  std::ranges::sort(trace, [](const Improvement& a, const Improvement& b) {
    return better(b.true_values, a.true_values);
  });
  for (std::size_t k = 1; k < trace.size(); ++k) {
    trace[k].evaluations = std::max(trace[k].evaluations, trace[k - 1].evaluations);
    trace[k].seconds = std::max(trace[k].seconds, trace[k - 1].seconds);
  }
  return trace;
}

inline std::string any_text(std::mt19937_64& random) {
  std::string text(random() % 6, ' ');
  for (char& c : text) c = "a'\"\\\n;\0\xFF"[random() % 8];
  return text;
}

/// Any record that a run may have.
inline RunRecord any_record(std::mt19937_64& random) {
  RunRecord record;
  record.problem = any_text(random);
  record.solver = any_text(random);
  record.instance = static_cast<int>(random() >> 33);
  record.run = static_cast<int>(random() >> 33);
  record.seed = random();
  record.budget = {any_count(random), random() % 2 == 0 ? infinity : any_time(random)};
  const std::int64_t charged =
      any_count(random) % std::max<std::int64_t>(1, record.budget.evaluations);
  record.ledger = {any_count(random), any_count(random), any_count(random),
                   charged,           any_count(random), any_time(random)};
  record.termination_reason = static_cast<TerminationReason>(random() % 6);
  for (auto left = random() % 20; left > 0; --left) {
    record.terminations.push_back(
        {random() % 3 == 0 ? any_text(random) : "again", any_point(random)});
  }
  if (random() % 2 == 0) {
    record.returned = ReturnedPoint{any_point(random), any_true_values(random)};
  }
  record.failure = any_text(random);
  record.trace = any_trace(random, charged);
  return record;
}

inline CampaignDescription a_description() {
  CampaignDescription description;
  description.plan = "solvers = [\"fast\"]\n";
  description.problems = {
      {"quiet", "speed", "C1", 1, 2, 1, 1e-6, -0.0, {{"friction", 0.25}}, {{"best_point", 0.1}}},
      {"valley", "classic", "", 2, 0, 0, 0, 1e300, {}, {}}};
  description.solvers = {{"slow", "2.1"}, {"fast", ""}};
  description.program = {{"version", "0.1.0"}, {"compiler", "GCC 12.2"}};
  description.made = {{"date", "2026-01-02"}, {"cores", "2"}};
  return description;
}

inline RunKey a_key(int number) {
  return {{number % 2 == 0 ? "valley" : "quiet", "count", "plain",
           number % 3 == 0 ? "slow" : "fast", number % 5 == 0 ? 1000 : 20, "n"},
          number % 7,
          number / 7};
}

/// Whether `stored` has every bit of the record that a store keeps, times too.
inline void expect_kept(const RunRecord& stored, const RunRecord& record) {
  EXPECT_EQ(stored.problem, record.problem);
  EXPECT_EQ(stored.solver, record.solver);
  EXPECT_EQ(stored.instance, record.instance);
  EXPECT_EQ(stored.run, record.run);
  EXPECT_EQ(stored.seed, record.seed);
  EXPECT_EQ(stored.budget.evaluations, record.budget.evaluations);
  EXPECT_TRUE(same_bits(stored.budget.seconds, record.budget.seconds));
  EXPECT_EQ(stored.ledger.values, record.ledger.values);
  EXPECT_EQ(stored.ledger.derivatives, record.ledger.derivatives);
  EXPECT_EQ(stored.ledger.hessians, record.ledger.hessians);
  EXPECT_EQ(stored.ledger.charged, record.ledger.charged);
  EXPECT_EQ(stored.ledger.refused, record.ledger.refused);
  EXPECT_TRUE(same_bits(stored.ledger.seconds, record.ledger.seconds));
  EXPECT_EQ(stored.termination_reason, record.termination_reason);
  EXPECT_EQ(stored.failure, record.failure);
  ASSERT_EQ(stored.terminations.size(), record.terminations.size());
  for (std::size_t k = 0; k < record.terminations.size(); ++k) {
    EXPECT_EQ(stored.terminations[k].reason, record.terminations[k].reason);
    EXPECT_FALSE(stored.terminations[k].point.has_value());
  }
  const auto expect_point = [](const Vector& x, const Vector& kept) {
    ASSERT_EQ(x.size(), kept.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) EXPECT_TRUE(same_bits(x[i], kept[i]));
  };
  const auto expect_true_values = [](const TrueValues& true_values, const TrueValues& kept) {
    EXPECT_TRUE(same_bits(true_values.objective, kept.objective));
    EXPECT_TRUE(same_bits(true_values.violation, kept.violation));
  };
  ASSERT_EQ(stored.returned.has_value(), record.returned.has_value());
  if (record.returned) {
    expect_point(stored.returned->x, record.returned->x);
    expect_true_values(stored.returned->true_values, record.returned->true_values);
  }
  ASSERT_EQ(stored.trace.size(), record.trace.size());
  for (std::size_t k = 0; k < record.trace.size(); ++k) {
    const bool last = k + 1 == record.trace.size();
    EXPECT_EQ(stored.trace[k].evaluations, record.trace[k].evaluations);
    EXPECT_TRUE(same_bits(stored.trace[k].seconds, record.trace[k].seconds));
    expect_true_values(stored.trace[k].true_values, record.trace[k].true_values);
    expect_point(stored.trace[k].x, last ? record.trace[k].x : Vector());
  }
}

}  // namespace ricochet
