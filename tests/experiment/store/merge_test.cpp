#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "ricochet/error.h"
#include "src/experiment/store.h"
#include "tests/support/files.h"
#include "tests/experiment/store/stored_runs.h"

namespace ricochet {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using testing::ThrowsMessage;

class Merge : public TemporaryFolder {
 protected:
  const fs::path out = folder_ / "all";

  Merge() {
    std::mt19937_64 random(1);
    for (int k = 0; k < 40; ++k) records.push_back(any_record(random));
  }

  /// A closed store of the runs from the first to before the last.
  fs::path part(const std::string& name, int first, int last,
                const CampaignDescription& description = a_description()) const {
    Store store = Store::create(folder_ / name, description);
    for (int k = first; k < last; ++k) {
      store.add(a_key(k), records[static_cast<std::size_t>(k)]);
    }
    return folder_ / name;
  }

  void expect_refused(const std::vector<fs::path>& parts, const std::string& reason) const {
    const auto files = std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
    EXPECT_THAT(
        [&] { merge(parts, out); },
        ThrowsMessage<InputError>(AllOf(StartsWith((parts.back()).string()), HasSubstr(reason))));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), files)
        << "no file is made";
  }

  std::vector<RunRecord> records;
};

TEST_F(Merge, OfPartsIsTheWhole) {
  const std::string whole = Store::open(part("whole", 0, 40), Store::For::reading).digest();
  CampaignDescription elsewhere = a_description();
  elsewhere.made = {{"machine", "another"}};
  const std::vector<fs::path> parts = {part("a", 20, 40), part("b", 0, 20, elsewhere),
                                       part("empty", 0, 0)};
  merge(parts, out);
  const Store merged = Store::open(out, Store::For::reading);
  EXPECT_EQ(merged.digest(), whole);
  EXPECT_EQ(merged.description().made, a_description().made);
  merged.each([&](const StoredRun& run) {
    for (int k = 0; k < 40; ++k) {
      if (a_key(k) == run.key) expect_kept(run.record, records[static_cast<std::size_t>(k)]);
    }
  });
  merge({parts[0], parts[0]}, folder_ / "twice");
  EXPECT_EQ(Store::open(folder_ / "twice", Store::For::reading).size(), 20);
}

TEST_F(Merge, TakesARunOnceThatTwoHave) {
  const fs::path first = part("a", 0, 25);
  records[24].ledger.seconds = 5;  // of which it keeps the first's
  const fs::path second = part("b", 20, 40);
  merge({first, second}, out);
  const Store merged = Store::open(out, Store::For::reading);
  EXPECT_EQ(merged.size(), 40);
  EXPECT_EQ(merged.digest(), Store::open(part("whole", 0, 40), Store::For::reading).digest());
}

TEST_F(Merge, RefusesOtherResultsOfTheSameRun) {
  const fs::path first = part("a", 0, 25);
  records[24].seed ^= 1;
  expect_refused({first, part("b", 24, 30)}, "differs in seed");
}

TEST_F(Merge, RefusesAnotherCampaign) {
  CampaignDescription another = a_description();
  another.program["compiler"] = "Clang 14";
  expect_refused({part("a", 0, 5), part("b", 5, 9, another)}, "differs in program's compiler");
}

TEST_F(Merge, RefusesWhatIsNoStore) {
  const fs::path first = part("a", 0, 5);
  expect_refused({first, folder_ / "missing"}, "No such file");
  EXPECT_THROW(merge({}, out), InputError);
  EXPECT_THROW(merge({first}, first), InputError);
  EXPECT_EQ(Store::open(first, Store::For::reading).size(), 5);
}

}  // namespace
}  // namespace ricochet
