#include <gtest/gtest.h>

#include <functional>

#include "src/experiment/merge.h"
#include "tests/experiment/store/stored_runs.h"

namespace ricochet {
namespace {

RunRecord a_record() {
  RunRecord record;
  record.problem = "quiet";
  record.solver = "fast";
  record.terminations = {{"done"}, {"done"}, {"stopped"}};
  record.returned = ReturnedPoint{Vector::Ones(2), {3, 0}};
  record.trace = {{1, 0.5, {4, 0}, {}}, {2, 0.7, {3, 0}, Vector::Ones(2)}};
  return record;
}

std::string digest(const CampaignDescription& description, const RunKey& key,
                   const RunRecord& record) {
  Digest digest(description);
  digest.add(key, record);
  return digest.text();
}

void flip_last_bit(double& number) {
  number = std::bit_cast<double>(std::bit_cast<std::uint64_t>(number) ^ 1U);
}

TEST(StoredParts, DifferWithEveryBitOfARun) {
  const std::pair<const char*, std::function<void(RunRecord&)>> changes[] = {
      {"names", [](RunRecord& r) { r.problem += ' '; }},
      {"names", [](RunRecord& r) { r.problem = "quietf", r.solver = "ast"; }},
      {"names", [](RunRecord& r) { r.instance ^= 1; }},
      {"names", [](RunRecord& r) { r.run ^= 1; }},
      {"seed", [](RunRecord& r) { r.seed ^= 1ULL << 63U; }},
      {"budget", [](RunRecord& r) { r.budget.evaluations ^= 1; }},
      {"budget", [](RunRecord& r) { flip_last_bit(r.budget.seconds); }},
      {"ledger", [](RunRecord& r) { r.ledger.values ^= 1; }},
      {"ledger", [](RunRecord& r) { r.ledger.derivatives ^= 1; }},
      {"ledger", [](RunRecord& r) { r.ledger.hessians ^= 1; }},
      {"ledger", [](RunRecord& r) { r.ledger.charged ^= 1; }},
      {"ledger", [](RunRecord& r) { r.ledger.refused ^= 1; }},
      {"end", [](RunRecord& r) { r.termination_reason = TerminationReason::seconds; }},
      {"end", [](RunRecord& r) { r.failure = "torn"; }},
      {"terminations", [](RunRecord& r) { r.terminations.pop_back(); }},
      {"terminations", [](RunRecord& r) { std::swap(r.terminations[1], r.terminations[2]); }},
      {"trace", [](RunRecord& r) { r.trace[0].evaluations ^= 2; }},
      {"trace", [](RunRecord& r) { flip_last_bit(r.trace[0].true_values.objective); }},
      {"trace", [](RunRecord& r) { r.trace[1].true_values.violation = -0.0; }},
      {"trace", [](RunRecord& r) { flip_last_bit(r.trace[1].x[1]); }},
      {"trace", [](RunRecord& r) { r.trace.clear(); }},
      {"point returned", [](RunRecord& r) { flip_last_bit(r.returned->x[0]); }},
      {"point returned", [](RunRecord& r) { flip_last_bit(r.returned->true_values.violation); }},
      {"point returned", [](RunRecord& r) { r.returned.reset(); }}};
  const RunRecord record = a_record();
  const std::string unchanged = digest(a_description(), a_key(1), record);
  for (const auto& [part, change] : changes) {
    RunRecord changed = record;
    change(changed);
    EXPECT_EQ(difference(parts_of(record), parts_of(changed)), part);
    EXPECT_EQ(difference(parts_of(changed), parts_of(record)), part);
    EXPECT_NE(digest(a_description(), a_key(1), changed), unchanged) << part;
  }
}

TEST(StoredParts, AreTheSameAtAnyTime) {
  RunRecord later = a_record();
  later.ledger.seconds = 1;
  later.trace[0].seconds = 2;
  EXPECT_EQ(difference(parts_of(a_record()), parts_of(later)), "");
  EXPECT_EQ(digest(a_description(), a_key(1), later),
            digest(a_description(), a_key(1), a_record()));
  EXPECT_NE(checksum(a_key(1), later, {}), checksum(a_key(1), a_record(), {}));
  CampaignDescription elsewhere = a_description();
  elsewhere.made.clear();
  EXPECT_EQ(difference(parts_of(a_description()), parts_of(elsewhere)), "");
  EXPECT_NE(checksum(a_description()), checksum(elsewhere));
}

TEST(StoredParts, DifferWithEveryBitOfAKey) {
  const std::function<void(RunKey&)> changes[] = {[](RunKey& k) { k.cell.problem += '-'; },
                                                  [](RunKey& k) { k.cell.formulation += '-'; },
                                                  [](RunKey& k) { k.cell.perturbation += '-'; },
                                                  [](RunKey& k) { k.cell.solver += '-'; },
                                                  [](RunKey& k) { k.cell.budget ^= 1; },
                                                  [](RunKey& k) { k.cell.gradient_price += '-'; },
                                                  [](RunKey& k) { k.instance ^= 1; },
                                                  [](RunKey& k) { k.run ^= 1; }};
  const std::string unchanged = digest(a_description(), a_key(1), a_record());
  for (const auto& change : changes) {
    RunKey key = a_key(1);
    change(key);
    EXPECT_NE(digest(a_description(), key, a_record()), unchanged);
    EXPECT_NE(checksum(key, a_record(), {}), checksum(a_key(1), a_record(), {}));
  }
}

TEST(StoredParts, DifferWithEveryBitOfADescription) {
  const std::pair<const char*, std::function<void(CampaignDescription&)>> changes[] = {
      {"plan", [](auto& d) { d.plan += ' '; }},
      {"problem quiet", [](auto& d) { flip_last_bit(d.problems[0].findings["best_point"]); }},
      {"problem quiet", [](auto& d) { std::swap(d.problems[0].findings, d.problems[0].factors); }},
      {"problem quiet", [](auto& d) { std::swap(d.problems[0], d.problems[1]); }},
      {"problem quiet", [](auto& d) { d.problems[0].family += ' '; }},
      {"problem quiet", [](auto& d) { d.problems[0].machine += ' '; }},
      {"problem quiet", [](auto& d) { d.problems[0].hash += ' '; }},
      {"problem valley", [](auto& d) { d.problems[1].variables ^= 1; }},
      {"problem valley", [](auto& d) { d.problems[1].constraints ^= 1; }},
      {"problem valley", [](auto& d) { d.problems[1].equalities ^= 1; }},
      {"problem quiet", [](auto& d) { flip_last_bit(d.problems[0].tolerance); }},
      {"problem quiet", [](auto& d) { d.problems[0].best_known = 0; }},
      {"problem quiet", [](auto& d) { flip_last_bit(d.problems[0].factors["friction"]); }},
      {"problem valley", [](auto& d) { d.problems[1].factors["friction"] = 0; }},
      {"problem valley", [](auto& d) { d.problems.pop_back(); }},
      {"solver slow of version 2.1", [](auto& d) { d.solvers[0].version = "2.2"; }},
      {"solver fast of version ", [](auto& d) { d.solvers.pop_back(); }},
      {"program's version, 0.1.0", [](auto& d) { d.program["version"] = "0.2.0"; }}};
  const std::string unchanged = digest(a_description(), a_key(1), a_record());
  for (const auto& [part, change] : changes) {
    CampaignDescription changed = a_description();
    change(changed);
    EXPECT_EQ(difference(parts_of(a_description()), parts_of(changed)), part);
    EXPECT_NE(digest(changed, a_key(1), a_record()), unchanged) << part;
  }
}

}  // namespace
}  // namespace ricochet
