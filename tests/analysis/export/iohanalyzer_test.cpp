#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "src/analysis/export/formats.h"
#include "tests/analysis/export/exported_store.h"
#include "tests/analysis/export/iohanalyzer_check.h"

namespace ricochet::exports {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

using IohAnalyzer = ExportedStore;

TEST_F(IohAnalyzer, OpensEveryAlgorithmWithAllOfItsRuns) {
  write_iohanalyzer(store, {}, out);
  std::vector<std::string> complaints;
  std::size_t runs = 0;
  int algorithms = 0;
  for (const auto& entry : fs::directory_iterator(out)) {
    if (!entry.is_directory()) continue;
    ++algorithms;
    for (const ReadCase& read : read_iohanalyzer(entry.path(), complaints)) {
      EXPECT_EQ(read.algorithm, entry.path().filename());
      runs += read.runs.size();
    }
  }
  EXPECT_THAT(complaints, IsEmpty());
  EXPECT_EQ(algorithms, 12) << "3 solvers, 2 perturbations, 2 budgets";
  EXPECT_EQ(runs, records.size());
  EXPECT_THAT(text_of(out / "README.txt"), HasSubstr("450 instead of 310"));
}

TEST_F(IohAnalyzer, RowsAreWhatTheRecordsSay) {
  write_iohanalyzer(store, {}, out);
  std::vector<std::string> complaints;
  const auto cases =
      read_iohanalyzer(out / "nlopt-cobyla_original_noisy_price-n_budget-30", complaints);
  ASSERT_EQ(cases.size(), 4U);
  for (const ReadCase& read : cases) {
    ASSERT_EQ(read.runs.size(), 6U);
    const auto& asked = *std::find_if(description.problems.begin(), description.problems.end(),
                                      [&](const auto& q) { return q.variables == read.dimension; });
    for (int k = 0; k < 6; ++k) {
      const ReadRun& run = read.runs[static_cast<std::size_t>(k)];
      const RunKey key{
          {asked.name, "original", "noisy", "nlopt-cobyla", 30, "n"}, 1 + k / 2, k % 2};
      const RunRecord& record = records.at(key);
      EXPECT_EQ(run.instance, key.instance);
      EXPECT_EQ(run.rows.back().evaluations, std::max<std::int64_t>(record.ledger.charged, 1));
      for (const ReadRow& row : run.rows) {
        EXPECT_EQ(row.raw_y, optimality_gap_after(key, row.evaluations)) << name_of(key);
        EXPECT_EQ(row.gevals, static_cast<double>(record.ledger.derivatives));
      }
    }
  }
}

TEST_F(IohAnalyzer, KnowsTheMachine) {
  write_iohanalyzer(store, {}, out);
  const auto data = nlohmann::json::parse(text_of(
      out / "nlopt-cobyla_original_plain_price-n_budget-2/IOHprofiler_f3_top-speed_C1.json"));
  EXPECT_THAT(data["experiment_attributes"].dump(),
              HasSubstr(R"({"disturbance":"0.3333333333333333"},{"friction":"0.25"})"));
}

/// Every rule of the check is broken once: it would see it.
TEST_F(IohAnalyzer, IsCheckedForEveryRule) {
  write_iohanalyzer(store, {}, out);
  const fs::path root = out / "nlopt-cobyla_original_plain_price-n_budget-30";
  const fs::path head = root / "IOHprofiler_f3_top-speed_C1.json";
  const fs::path rows = root / "data_f3_top-speed_C1/IOHprofiler_f3_DIM1.dat";
  // Known rows of one run, whatever the store has.
  auto data = nlohmann::json::parse(text_of(head));
  data["scenarios"][0]["runs"] = {
      {{"instance", 1}, {"evals", 9}, {"best", {{"evals", 4}, {"y", 0.5}, {"x", {1}}}}}};
  const std::string good_head = data.dump();
  const std::string good_rows =
      "evaluations raw_y time_s gevals\n1 3 0 0\n4 0.5 0.1 0\n9 0.5 1 0\n";
  const auto complaints = [&](const std::string& its_head, const std::string& its_rows) {
    std::ofstream(head) << its_head;
    std::ofstream(rows) << its_rows;
    std::vector<std::string> found;
    read_iohanalyzer(root, found);
    return found;
  };
  EXPECT_THAT(complaints(good_head, good_rows), IsEmpty());
  const auto replaced = [](std::string text, const std::string& from, const std::string& to) {
    EXPECT_NE(text.find(from), std::string::npos) << from;
    return text.replace(text.find(from), from.size(), to);
  };
  const std::vector<std::vector<std::string>> in_rows = {
      {"evaluations raw_y time_s gevals\n", "", "no header before"},
      {"1 3 0 0\n", "2 3 0 0\n", "first row is not"},
      {"4 0.5", "1 0.5", "do not rise"},
      {"4 0.5", "4 4", "raw_y rises"},
      {"4 0.5", "4 3", "repeated raw_y"},
      {"4 0.5 ", "4  0.5 ", "not four numbers"},
      {"4 0.5 ", "4 inf ", "not four numbers"},
      {"4 0.5 0.1 0", "4 0.5 0.1", "not four numbers"},
      {"9 0.5", "8 0.5", "evals is not the last"},
      {"4 0.5 0.1 0\n9 0.5", "4 0.6 0.1 0\n9 0.6", "best is not that"},
      {"1 3 0 0\n", "1 3 0 0\nevaluations raw_y time_s gevals\n", "not as many runs"}};
  for (const auto& broken : in_rows) {
    EXPECT_THAT(complaints(good_head, replaced(good_rows, broken[0], broken[1])),
                Contains(HasSubstr(broken[2])));
  }
  const std::vector<std::vector<std::string>> in_head = {
      {"0.3.18", "0.3.2", "version"},
      {"\"maximization\":false", "\"maximization\":true", "no minimisation"},
      {"\"time_s\"", "\"seconds\"", "attributes are not"},
      {"\"0.25\"", "0.25", "experiment attribute"},
      {"\"info\"", "\"note\"", "name and info"},
      {"\"suite\"", "\"suit\"", "other members at the top"},
      {"\"function_id\":3", "\"function_id\":4", "another name"},
      {"/IOHprofiler_f3_DIM1", "/IOHprofiler_f3_DIM2", "path is not"},
      {"\"y\":0.5", "\"f\":0.5", "exactly evals, y and x"},
      {"\"instance\":1", "\"number\":1", "a run has other members"},
      {"{", "", "no JSON"}};
  for (const auto& broken : in_head) {
    EXPECT_THAT(complaints(replaced(good_head, broken[0], broken[1]), good_rows),
                Contains(HasSubstr(broken[2])));
  }
  std::ofstream(root / "data_f3_top-speed_C1" / "more.info") << "";
  EXPECT_THAT(complaints(good_head, good_rows), Contains(HasSubstr("another file")));
}

}  // namespace
}  // namespace ricochet::exports
