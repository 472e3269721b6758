#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "src/experiment/store.h"
#include "tests/app/tool.h"

/// Stores that somebody changed and gave the right checksums again, which have no secret.
namespace ricochet::cli {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ForgedStores : public testing::Test {
 protected:
  void SetUp() override {
    const fs::path plan =
        write(folder_, "plan.toml",
              "name = \"small\"\n[[part]]\n"
              "problems = [\"classic-sphere-5\", \"hs-71\", \"count-C1\", \"top-speed-C1\"]\n"
              "solvers = [\"random-search\", \"nlopt-cobyla\"]\nbudgets = [30]\ninstances = 4\n");
    ASSERT_EQ(
        call(fmt::format("run {} --out {}", plan.string(), (folder_ / "made").string())).exit_code,
        0);
  }

  /// A store of the same runs, some of them changed.
  std::string forged(const std::string& name,
                     const std::function<void(CampaignDescription&)>& describe,
                     const std::function<void(const RunKey&, RunRecord&)>& change) const {
    const std::string file = (folder_ / name).string();
    const Store honest = Store::open(honest_, Store::For::reading);
    CampaignDescription description = honest.description();
    describe(description);
    Store::write(file, description, [&](const Store::AddRun& add) {
      honest.each([&](const StoredRun& run) {
        RunRecord record = run.record;
        change(run.key, record);
        add(run.key, record);
      });
    });
    return file;
  }

  std::string with_problem(const std::string& name, const std::string& problem,
                           const std::function<void(StoredProblem&)>& change) const {
    return forged(
        name,
        [&](CampaignDescription& description) {
          for (StoredProblem& one : description.problems) {
            if (one.name == problem) change(one);
          }
        },
        [](const RunKey&, RunRecord&) {});
  }

  std::string with_runs(const std::string& name, const std::string& problem,
                        const std::function<void(RunRecord&)>& change) const {
    return forged(
        name, [](CampaignDescription&) {},
        [&](const RunKey& key, RunRecord& record) {
          if (problem.empty() || key.cell.problem == problem) change(record);
        });
  }

  std::vector<std::string> readers(const std::string& store) const {
    const std::string out = folder_.string();
    return {"digest " + store,
            fmt::format("export {} --format csv --out {}/csv", store, out),
            fmt::format("submit {} --solvers '*' --out {}/a --verify 0", store, out),
            fmt::format("merge {}/m {} --verify 0", out, store),
            fmt::format("merge {}/m {} {} --verify 0", out, honest_, store),
            fmt::format("merge {}/m {} {} --verify 0", out, store, honest_),
            fmt::format("compare --stores {} {}", honest_, store)};
  }

  const fs::path folder_ = fresh_folder();
  const std::string honest_ = (folder_ / "made" / "runs.sqlite").string();
};

TEST_F(ForgedStores, AreRefusedWhereTheyContradictWhatIsKnown) {
  std::vector<std::pair<std::string, std::string>> forgeries;
  const auto problem = [&](const std::string& name, const char* words,
                           const std::function<void(StoredProblem&)>& change) {
    forgeries.emplace_back(with_problem(fmt::format("{}.sqlite", forgeries.size()), name, change),
                           words);
  };
  const auto runs = [&](const std::string& name, const char* words,
                        const std::function<void(RunRecord&)>& change) {
    forgeries.emplace_back(with_runs(fmt::format("{}.sqlite", forgeries.size()), name, change),
                           words);
  };
  problem("hs-71", "best_known of hs-71 is", [](auto& p) { p.best_known += 1; });
  problem("hs-71", "tolerance of hs-71 is 100", [](auto& p) { p.tolerance = 100; });
  problem("count-C1", "variables of count-C1 is 3", [](auto& p) { p.variables = 3; });
  problem("count-C1", "count-C1 is not described as", [](auto& p) { p.family = "classic"; });
  problem("top-speed-C1", "top-speed-C1 is not described as",
          [](auto& p) { p.findings["best_known"] = -9; });
  const auto returns = [](double objective) {
    return [objective](RunRecord& record) {
      if (record.returned) record.returned->true_values = {objective, 0.0};
    };
  };
  runs("count-C1", "it is proven that none is better than", returns(-1));
  runs("top-speed-C1", "it is proven that none is better than", returns(-9));
  runs("classic-sphere-5", "it is proven that none is better than 0", returns(-0.001));
  runs("classic-sphere-5", "it is proven",
       [](RunRecord& record) { record.trace.back().true_values.objective = -2; });
  runs("hs-71", "the plan allows 120", [](auto& record) { record.budget.evaluations = 1'000'000; });
  runs("hs-71", "returned_x has 2 coordinates: must be 4", [](RunRecord& record) {
    if (record.returned) record.returned->x = Vector::Zero(2);
  });
  for (const auto& [store, words] : forgeries) {
    for (const std::string& reader : readers(store)) expect_refusal(reader, words);
    EXPECT_FALSE(fs::exists(folder_ / "m")) << words;
    EXPECT_FALSE(fs::exists(folder_ / "a")) << words;
  }
}

/// What could be true is found by repeating runs.
TEST_F(ForgedStores, AreRefusedWhereARunThatIsRepeatedDiffers) {
  std::vector<std::string> forgeries = {
      with_runs("seconds.sqlite", "",
                [](RunRecord& record) {
                  record.ledger.charged -= record.ledger.charged > 1 ? 1 : 0;
                  if (!record.trace.empty()) {
                    for (Improvement& step : record.trace) {
                      step.evaluations = std::min(step.evaluations, record.ledger.charged);
                    }
                  }
                }),
      with_runs("returned.sqlite", "",
                [](RunRecord& record) {
                  if (record.returned) record.returned->x[0] += 1e-12;
                  record.seed ^= 1;
                }),
      with_runs("failure.sqlite", "", [](RunRecord& record) { record.failure = "crashed"; }),
      with_runs("ended.sqlite", "",
                [](RunRecord& record) { record.terminations = {{"converged"}}; }),
      with_runs("asked.sqlite", "", [](RunRecord& record) { record.ledger.refused += 1; })};
  for (const std::string& store : forgeries) {
    EXPECT_EQ(call("digest " + store).exit_code, 0) << store;
    for (const std::string& taken :
         {fmt::format("submit {} --solvers '*' --out {}/a", store, folder_.string()),
          fmt::format("merge {}/m {}", folder_.string(), store)}) {
      expect_refusal(taken, "when it is repeated: it is not what this program does");
    }
    EXPECT_FALSE(fs::exists(folder_ / "m"));
    EXPECT_FALSE(fs::exists(folder_ / "a"));
  }
}

TEST_F(ForgedStores, AreSaidNotToBeCheckedWhereAProblemIsAnother) {
  const std::string other = with_problem("other.sqlite", "hs-71", [](StoredProblem& problem) {
    problem.tolerance = 100;
    problem.hash = "0123456789abcdef";
  });
  const Outcome outcome = call("digest " + other);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("1 problem is not this program's, by hash"));
  EXPECT_THAT(outcome.err, HasSubstr("hs-71"));
  expect_refusal(fmt::format("merge {}/m {} {} --verify 0", folder_.string(), honest_,
                             with_problem("same.sqlite", "hs-71",
                                          [](StoredProblem& problem) { problem.tolerance = 9; })),
                 "tolerance of hs-71 is 9");
}

/// A sample of the stated size is repeated; how many, by whom and when stays with the runs, and a
/// report of them begins with it.
TEST_F(ForgedStores, AreToldFromStoresWhoseRunsWereRepeated) {
  const auto merged = [&](const std::string& name, const std::string& how) {
    const Outcome outcome =
        call(fmt::format("merge {}/{}.sqlite {} {}", folder_.string(), name, honest_, how));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return Store::open(folder_ / (name + ".sqlite"), Store::For::reading).description().made;
  };
  const auto by_default = merged("a", "");
  EXPECT_THAT(by_default.at("verified"),
              testing::MatchesRegex("20 of [0-9]+ runs, drawn at random, were repeated to the last "
                                    "bit by .+ with ricochet .+ on 20[0-9-]+"));
  EXPECT_EQ(by_default.at("joined"), "1 store");
  EXPECT_THAT(merged("b", "--verify 3").at("verified"), testing::StartsWith("3 of "));
  EXPECT_THAT(merged("c", "--verify 0").at("verified"), HasSubstr("runs was repeated"));
  fs::create_directory(folder_ / "there");
  fs::copy(folder_ / "b.sqlite", folder_ / "there" / "runs.sqlite");
  ASSERT_EQ(
      call(fmt::format("run {0}/plan.toml --out {0}/there --resume", folder_.string())).exit_code,
      0);
  EXPECT_THAT(read(folder_ / "there" / "summary.md"),
              HasSubstr("The runs of 1 store were joined. Of these runs, 3 of "));
  EXPECT_THAT(read(folder_ / "made" / "summary.md"), testing::Not(HasSubstr("were joined")));
  ASSERT_EQ(
      call(fmt::format("run {0}/plan.toml --out {0}/from --from {1}", folder_.string(), honest_))
          .exit_code,
      0);
  EXPECT_THAT(read(folder_ / "from" / "summary.md"), HasSubstr("Some runs taken over from "));
}

}  // namespace
}  // namespace ricochet::cli
