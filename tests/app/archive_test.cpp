#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "src/report/results.h"
#include "src/report/text.h"
#include "tests/app/tool.h"

/// From a campaign to an archive, and a user's solver beside it.
namespace ricochet::cli {
namespace {

namespace fs = std::filesystem;
using report::Json;
using testing::HasSubstr;

const std::string own = RICOCHET_EXAMPLE_LIBRARY;

class Archives : public testing::Test {
 protected:
  const fs::path folder_ = fresh_folder();
  const std::string archive_ = (folder_ / "small.archive").string();

  static std::string out_of(const std::string& arguments) {
    const Outcome outcome = call(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << arguments << outcome.err;
    return outcome.out;
  }

  /// An archive of two solvers on six problems.
  void SetUp() override {
    const fs::path plan = write(folder_, "plan.toml",
                                "name = \"small\"\n[[part]]\nproblems = [\"classic-*-5\"]\n"
                                "solvers = [\"random-search\", \"nlopt-bobyqa\"]\n"
                                "budgets = [30]\ninstances = 2\n");
    out_of(fmt::format("run {} --out {}", plan.string(), (folder_ / "made").string()));
    EXPECT_THAT(out_of(fmt::format("submit {} --solvers '*' --out {}",
                                   (folder_ / "made" / "runs.sqlite").string(), archive_)),
                HasSubstr("runs, drawn at random, were repeated to the last bit"));
  }

  /// Puts the example library beside it; the folder of the report.
  fs::path compared() const {
    const fs::path out = folder_ / "mine";
    out_of(fmt::format("compare --solver {} --against {} --out {}", own, archive_, out.string()));
    return out;
  }
};

TEST_F(Archives, AreReadAsStores) {
  EXPECT_THAT(out_of("replay " + archive_ + " 3"), HasSubstr("The same, to the last bit"));
  EXPECT_EQ(out_of("digest " + archive_).size(), 17U);
  out_of(fmt::format("export {} --format csv --out {}", archive_, (folder_ / "csv").string()));
  EXPECT_THAT(read(folder_ / "csv" / "runs.csv"), HasSubstr("nlopt-bobyqa"));
}

TEST_F(Archives, StandBesideAUsersSolver) {
  const fs::path out = compared();
  const report::Results data = report::results_in(report::data_in(read(out / "data.json")));
  const Table& totals = *data.table("own-totals");
  ASSERT_EQ(totals.rows.size(), 1U);
  EXPECT_EQ(totals[0].text("solver"), "mine");
  const Row own = (*data.table("own-solvers"))[0];
  EXPECT_EQ(own.number("rivals"), 2);
  EXPECT_EQ(own.text("family"), "classic");
  EXPECT_EQ(number_in(*data.value("runs")), 3 * 2 * *number_in(*data.value("problems")));
  EXPECT_THAT(read(out / "summary.md"), HasSubstr("Your solver"));
}

TEST_F(Archives, TakeInWhatIsSubmitted) {
  const std::string store = (compared() / "runs.sqlite").string();
  const std::string mine = (folder_ / "mine.archive").string();
  write(folder_, "CITATION.cff", "title: mine\n");
  EXPECT_THAT(out_of(fmt::format("submit {} --out {} --citation {} --allow-programs", store, mine,
                                 (folder_ / "CITATION.cff").string())),
              HasSubstr("runs of mine"));
  const std::string all = (folder_ / "all.sqlite").string();
  out_of(fmt::format("merge {} {} {}", all, archive_, mine));
  out_of(fmt::format("export {} --format csv --out {}", all, (folder_ / "csv").string()));
  const std::string runs = read(folder_ / "csv" / "runs.csv");
  EXPECT_THAT(runs, HasSubstr("mine"));
  EXPECT_THAT(runs, HasSubstr("nlopt-bobyqa"));
}

TEST_F(Archives, AreRefusedInOneLine) {
  expect_refusal("compare --against " + archive_, "--against: needs --solver, your own solver");
  expect_refusal(fmt::format("compare --solver {} --against {}", own,
                             write(folder_, "text", "no archive").string()),
                 "file is not a database");
  expect_refusal(fmt::format("submit {} --out {}", archive_, (folder_ / "again.archive").string()),
                 "has only solvers of the suite");
  EXPECT_FALSE(fs::exists(folder_ / "again.archive"));
}

}  // namespace
}  // namespace ricochet::cli
