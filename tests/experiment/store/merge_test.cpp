#include "src/experiment/merge.h"

#include "tests/experiment/store/stored.h"

namespace ricochet {
namespace {

class Merge : public TemporaryFolder {
 protected:
  /// A closed store of the runs from the first to before the last.
  fs::path part(const std::string& name, int first, int last,
                const CampaignDescription& description = a_description()) const {
    Store store = Store::create(folder_ / name, description);
    add(store, {records_.begin() + first, records_.begin() + last}, first);
    return folder_ / name;
  }

  void expect_refused(const fs::path& first, const fs::path& second,
                      const std::string& reason) const {
    const auto files = number_of_files(folder_);
    const auto merging = [&] { return merge({first, second}, out_), 0; };
    EXPECT_THAT(complaint_of(merging), AllOf(StartsWith(second.string()), HasSubstr(reason)));
    EXPECT_EQ(number_of_files(folder_), files) << "no file is made";
  }

  const fs::path out_ = folder_ / "all";
  std::vector<RunRecord> records_ = any_records(40, 1);
};

TEST_F(Merge, OfPartsIsTheWhole) {
  const Store whole = reading(part("whole", 0, 40));
  CampaignDescription elsewhere = a_description();
  elsewhere.made = {{"machine", "another"}};
  const fs::path first = part("a", 20, 40);
  merge({first, part("b", 0, 20, elsewhere), part("empty", 0, 0)}, out_);
  const Store merged = reading(out_);
  Digest digest(a_description());
  for (const RunKey& key : whole.keys()) digest.add(key, whole.find(key)->record);
  EXPECT_EQ(merged.digest(), digest.text());
  EXPECT_EQ(whole.digest(), digest.text());
  EXPECT_EQ(merged.description().made, a_description().made);
  EXPECT_EQ(bits_of(merged), bits_of(whole));
}

TEST_F(Merge, TakesARunOnceThatTwoHave) {
  const fs::path whole = part("whole", 0, 40), first = part("a", 0, 25);
  records_[24].ledger.seconds = 5;  // of which it keeps the first's
  merge({first, part("b", 20, 40)}, out_);
  EXPECT_EQ(bits_of(reading(out_)), bits_of(reading(whole)));
}

TEST_F(Merge, RefusesAnotherCampaignOrOtherResultsOfTheSameRun) {
  const fs::path first = part("a", 0, 25);
  records_[24].seed ^= 1;
  expect_refused(first, part("b", 24, 30), "differs in seed");
  CampaignDescription another = a_description();
  another.program["compiler"] = "Clang 14";
  expect_refused(first, part("c", 25, 29, another), "differs in program's compiler");
}

TEST_F(Merge, RefusesWhatIsNoStore) {
  const fs::path first = part("a", 0, 5);
  expect_refused(first, folder_ / "missing", "No such file");
  EXPECT_THROW(merge({}, out_), InputError);
  EXPECT_THROW(merge({first}, first), InputError);
  EXPECT_EQ(reading(first).size(), 5);
}

RunRecord a_record() {
  RunRecord record;
  record.problem = "quiet";
  record.solver = "fast";
  record.terminations = {{"done"}, {"done"}, {"stopped"}};
  record.returned = ReturnedPoint{Vector::Ones(2), {3, 0}};
  record.trace = {{1, 0.5, {4, 0}, {}}, {2, 0.7, {3, 0}, Vector::Ones(2)}};
  return record;
}

std::string digest(const CampaignDescription& description = a_description(),
                   const RunKey& key = a_key(1), const RunRecord& record = a_record()) {
  Digest digest(description);
  digest.add(key, record);
  return digest.text();
}

void flip_last_bit(double& number) {
  number = std::bit_cast<double>(std::bit_cast<std::uint64_t>(number) ^ 1U);
}

/// The part that a change makes differ, and the change.
template <class Thing>
using Changes = std::vector<std::pair<std::string, std::function<void(Thing&)>>>;

TEST(StoredParts, DifferWithEveryBitOfARun) {
  const Changes<RunRecord> changes = {
      {"names", [](auto& r) { r.problem += ' '; }},
      {"names", [](auto& r) { r.problem = "quietf", r.solver = "ast"; }},
      {"names", [](auto& r) { r.instance ^= 1; }},
      {"names", [](auto& r) { r.run ^= 1; }},
      {"seed", [](auto& r) { r.seed ^= 1ULL << 63U; }},
      {"budget", [](auto& r) { r.budget.evaluations ^= 1; }},
      {"budget", [](auto& r) { flip_last_bit(r.budget.seconds); }},
      {"ledger", [](auto& r) { r.ledger.values ^= 1; }},
      {"ledger", [](auto& r) { r.ledger.derivatives ^= 1; }},
      {"ledger", [](auto& r) { r.ledger.hessians ^= 1; }},
      {"ledger", [](auto& r) { r.ledger.charged ^= 1; }},
      {"ledger", [](auto& r) { r.ledger.refused ^= 1; }},
      {"end", [](auto& r) { r.termination_reason = TerminationReason::seconds; }},
      {"end", [](auto& r) { r.failure = "torn"; }},
      {"terminations", [](auto& r) { r.terminations.pop_back(); }},
      {"terminations", [](auto& r) { std::swap(r.terminations[1], r.terminations[2]); }},
      {"trace", [](auto& r) { r.trace[0].evaluations ^= 2; }},
      {"trace", [](auto& r) { flip_last_bit(r.trace[0].true_values.objective); }},
      {"trace", [](auto& r) { r.trace[1].true_values.violation = -0.0; }},
      {"trace", [](auto& r) { flip_last_bit(r.trace[1].x[1]); }},
      {"trace", [](auto& r) { r.trace.clear(); }},
      {"point returned", [](auto& r) { flip_last_bit(r.returned->x[0]); }},
      {"point returned", [](auto& r) { flip_last_bit(r.returned->true_values.violation); }},
      {"point returned", [](auto& r) { r.returned.reset(); }}};
  const auto parts = parts_of(a_record());
  for (const auto& [part, change] : changes) {
    RunRecord changed = a_record();
    change(changed);
    EXPECT_EQ(difference(parts, parts_of(changed)), part);
    EXPECT_EQ(difference(parts_of(changed), parts), part);
    EXPECT_NE(digest(a_description(), a_key(1), changed), digest()) << part;
  }
}

TEST(StoredParts, AreTheSameAtAnyTime) {
  RunRecord later = a_record();
  later.ledger.seconds = 1;
  later.trace[0].seconds = 2;
  EXPECT_EQ(difference(parts_of(a_record()), parts_of(later)), "");
  EXPECT_EQ(digest(a_description(), a_key(1), later), digest());
  EXPECT_NE(checksum(a_key(1), later, {}), checksum(a_key(1), a_record(), {}));
  CampaignDescription elsewhere = a_description();
  elsewhere.made.clear();
  EXPECT_EQ(difference(parts_of(a_description()), parts_of(elsewhere)), "");
  EXPECT_NE(checksum(a_description()), checksum(elsewhere));
}

TEST(StoredParts, DifferWithEveryBitOfAKey) {
  const Changes<RunKey> changes = {{"problem", [](auto& k) { k.cell.problem += '-'; }},
                                   {"formulation", [](auto& k) { k.cell.formulation += '-'; }},
                                   {"perturbation", [](auto& k) { k.cell.perturbation += '-'; }},
                                   {"solver", [](auto& k) { k.cell.solver += '-'; }},
                                   {"budget", [](auto& k) { k.cell.budget ^= 1; }},
                                   {"price", [](auto& k) { k.cell.gradient_price += '-'; }},
                                   {"instance", [](auto& k) { k.instance ^= 1; }},
                                   {"run", [](auto& k) { k.run ^= 1; }}};
  for (const auto& [part, change] : changes) {
    RunKey key = a_key(1);
    change(key);
    EXPECT_NE(digest(a_description(), key), digest()) << part;
    EXPECT_NE(checksum(key, a_record(), {}), checksum(a_key(1), a_record(), {})) << part;
  }
}

TEST(StoredParts, DifferWithEveryBitOfADescription) {
  const Changes<CampaignDescription> changes = {
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
  for (const auto& [part, change] : changes) {
    CampaignDescription changed = a_description();
    change(changed);
    EXPECT_EQ(difference(parts_of(a_description()), parts_of(changed)), part);
    EXPECT_NE(digest(changed), digest()) << part;
  }
}

}  // namespace
}  // namespace ricochet
