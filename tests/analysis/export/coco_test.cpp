#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "src/analysis/export/formats.h"
#include "tests/analysis/export/coco_check.h"
#include "tests/analysis/export/exported_store.h"

namespace ricochet::exports {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

using Coco = ExportedStore;

TEST_F(Coco, OpensEveryAlgorithmWithAllOfItsRuns) {
  write_coco(store, {}, out);
  std::vector<std::string> complaints;
  std::size_t runs = 0;
  int algorithms = 0;
  for (const auto& entry : fs::directory_iterator(out)) {
    if (!entry.is_directory()) continue;
    ++algorithms;
    for (const CocoCase& read : read_coco(entry.path(), complaints)) {
      EXPECT_EQ(read.algorithm, entry.path().filename());
      const bool opens = read.dimension == 5 || read.dimension == 6;
      EXPECT_EQ(opens, read.function_id <= 2) << "those that can be opened come first";
      runs += read.runs.size();
    }
  }
  EXPECT_THAT(complaints, IsEmpty());
  EXPECT_EQ(algorithms, 12);
  EXPECT_EQ(runs, records.size());
  EXPECT_THAT(text_of(out / "README.txt"), HasSubstr("functions 1 to 24."));
}

TEST_F(Coco, RowsAreWhatTheRecordsSay) {
  write_coco(store, {}, out);
  std::vector<std::string> complaints;
  const auto cases = read_coco(out / "nlopt-cobyla_original_noisy_price-n_budget-30", complaints);
  ASSERT_EQ(cases.size(), 4U);
  for (const CocoCase& read : cases) {
    ASSERT_EQ(read.runs.size(), 6U);
    const auto& asked = *std::find_if(description.problems.begin(), description.problems.end(),
                                      [&](const auto& q) { return q.variables == read.dimension; });
    for (int k = 0; k < 6; ++k) {
      const CocoRun& run = read.runs[static_cast<std::size_t>(k)];
      const RunKey key{
          {asked.name, "original", "noisy", "nlopt-cobyla", 30, "n"}, 1 + k / 2, k % 2};
      const RunRecord& record = records.at(key);
      EXPECT_EQ(run.instance, key.instance);
      EXPECT_EQ(run.fopt, asked.best_known);
      for (const auto* rows : {&run.improvements, &run.counts}) {
        EXPECT_EQ(rows->back().evaluations, std::max<std::int64_t>(record.ledger.charged, 1));
        for (const CocoRow& row : *rows) {
          EXPECT_EQ(row.optimality_gap, optimality_gap_after(key, row.evaluations)) << name_of(key);
          if (row.optimality_gap == 1e30) continue;
          EXPECT_EQ(row.measured, row.optimality_gap + asked.best_known);
        }
      }
      if (run.counts.back().optimality_gap < 1e30) {
        const Vector& x = record.trace.back().x;
        EXPECT_EQ(run.counts.back().x, std::vector<double>(x.begin(), x.end()));
      } else {
        EXPECT_TRUE(std::isnan(run.counts.back().x[0]));
      }
    }
  }
}

TEST_F(Coco, HasRowsAtRoundNumbersOfEvaluations) {
  write_coco(store, {}, out);
  std::vector<std::string> complaints;
  for (const CocoCase& read :
       read_coco(out / "nlopt-cobyla_original_noisy_price-n_budget-30", complaints)) {
    for (const CocoRun& run : read.runs) {
      const std::vector<std::int64_t> round = {1, 2, 5, 10, 20, 50, 100, 200};
      for (std::size_t k = 0; k + 1 < run.counts.size(); ++k) {
        EXPECT_EQ(run.counts[k].evaluations, round.at(k));
      }
    }
  }
}

/// Every rule of the check is broken once: it would see it.
TEST_F(Coco, IsCheckedForEveryRule) {
  const fs::path root = folder_ / "root";
  fs::create_directories(root / "data_f1");
  const std::string info =
      "suite = 'bbob-mixint', funcId = 1, DIM = 1, Precision = 1.000e-08, algId = 'fw', "
      "coco_version = '2.8.0', logger = 'bbob', data_format = 'bbob-new2'\n% comment\n"
      "data_f1/bbobexp_f1_DIM1.dat, 1:200|0.0e+00\n";
  const std::string rows =
      "% f evaluations | g evaluations | best noise-free fitness - Fopt (3.000000000000e+00) + sum "
      "g_i+ | measured fitness | best measured fitness or single-digit g-values | x1\n"
      "1 0 +5.0e+01 +5.3e+01 +5.3e+01 nan\n200 0 +0.0e+00 +3.0e+00 +3.0e+00 +1.0e-01\n";
  const auto complaints = [&](const std::string& its_info, const std::string& its_rows,
                              const std::string& its_counts) {
    std::ofstream(root / "bbobexp_f1.info") << its_info;
    std::ofstream(root / "data_f1/bbobexp_f1_DIM1.dat") << its_rows;
    std::ofstream(root / "data_f1/bbobexp_f1_DIM1.tdat") << its_counts;
    std::vector<std::string> found;
    read_coco(root, found);
    return found;
  };
  EXPECT_THAT(complaints(info, rows, rows), IsEmpty());
  const auto replaced = [](std::string text, const std::string& from, const std::string& to) {
    EXPECT_NE(text.find(from), std::string::npos) << from;
    return text.replace(text.find(from), from.size(), to);
  };
  const std::vector<std::vector<std::string>> in_rows = {
      {"g_i+ | measured", "| measured", "another header"},
      {"(3.000000000000e+00)", "(3)", "another header"},
      {" | x1", "", "another header"},
      {" nan", "", "no row"},
      {"+5.3e+01 nan", "nan nan", "no row"},
      {"+5.0e+01", "inf", "no row"},
      {"1 0 ", "2 0 ", "first row is not"},
      {"200 0", "1 0", "do not rise"},
      {"+0.0e+00", "+9.0e+01", "optimality gap rises"},
      {"+0.0e+00", "+1.0e+01", "another optimality gap"},
      {"200 0", "199 0", "do not end at the last"}};
  for (const auto& broken : in_rows) {
    const std::string text = replaced(rows, broken[0], broken[1]);
    EXPECT_THAT(complaints(info, text, rows), Contains(HasSubstr(broken[2])));
    EXPECT_THAT(complaints(info, rows, text), Contains(HasSubstr(broken[2])));
  }
  const std::vector<std::vector<std::string>> in_info = {
      {"bbob-mixint", "bbob", "no three lines"},
      {"'fw'", "'f, w'", "no three lines"},
      {"% comment\n", "", "no three lines"},
      {"funcId = 1", "funcId = 2", "another name"},
      {"_DIM1.dat", "_DIM2.dat", "no path"},
      {"1:200|0.0e+00", "1:200 0.0e+00", "no list of runs"},
      {", 1:200|0.0e+00", "", "no path"},
      {"1:200|0.0e+00", "1:200|0.0e+00, 2:200|0.0e+00", "not as many runs"},
      {"1:200|0.0e+00\n", "1:200|0.0e+00\nmore\n", "no three lines"}};
  for (const auto& broken : in_info) {
    EXPECT_THAT(complaints(replaced(info, broken[0], broken[1]), rows, rows),
                Contains(HasSubstr(broken[2])))
        << broken[0];
  }
  EXPECT_THAT(complaints(info, rows + rows, rows), Contains(HasSubstr("not as many runs")));
  EXPECT_THAT(complaints(info + "\n" + info, rows, rows), Contains("a dimension twice"));
  fs::remove(root / "data_f1/bbobexp_f1_DIM1.tdat");
  std::vector<std::string> found;
  read_coco(root, found);
  EXPECT_THAT(found, Contains("rows are missing"));
}

}  // namespace
}  // namespace ricochet::exports
