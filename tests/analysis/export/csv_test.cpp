#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "src/analysis/export/formats.h"
#include "src/report/table.h"
#include "tests/analysis/export/exported_store.h"

namespace ricochet::exports {
namespace {

using testing::ElementsAre;

using CsvRows = std::vector<std::map<std::string, std::string>>;

/// The grammar of RFC 4180, section 2, with a line feed for its line break: all fields of all rows.
std::vector<std::vector<std::string>> fields_in(const std::string& text) {
  std::vector<std::vector<std::string>> rows(1, {""});
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string& field = rows.back().back();
    if (quoted && text[i] == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      field += text[++i];
    } else if (text[i] == '"' && (quoted || field.empty())) {
      quoted = !quoted;
    } else if (text[i] == ',' && !quoted) {
      rows.back().emplace_back();
    } else if (text[i] == '\n' && !quoted) {
      rows.push_back({""});
    } else {
      EXPECT_TRUE(quoted || text[i] != '"') << "a quote within a field that is not quoted";
      field += text[i];
    }
  }
  EXPECT_THAT(rows.back(), ElementsAre("")) << "the last row ends, too";
  rows.pop_back();
  return rows;
}

CsvRows table_in(const std::string& text) {
  const auto rows = fields_in(text);
  CsvRows table;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    EXPECT_EQ(rows[k].size(), rows[0].size());
    table.emplace_back();
    for (std::size_t i = 0; i < rows[0].size(); ++i) table.back()[rows[0][i]] = rows[k].at(i);
  }
  return table;
}

double read(const std::string& text) {
  return std::strtod(text.c_str(), nullptr);
}

TEST(CsvRow, ReadsBackToItsFields) {
  const std::vector<std::string> fields = {"", "plain", "a,b", "\"", "say \"so\"", " ", ",,\"\",,"};
  Table table{"fields", columns_named("a,b,c,d,e,f,g")};
  table.add_row({fields.begin(), fields.end()});
  EXPECT_THAT(fields_in(csv_of(table, Lines::rows)), ElementsAre(fields));
}

using Csv = ExportedStore;

TEST_F(Csv, HasEveryRunWithItsVerdict) {
  write_csv(store, {}, out);
  const CsvRows runs = table_in(text_of(out / "runs.csv"));
  ASSERT_EQ(runs.size(), records.size());
  auto expected = records.begin();  // a store hands them over in the order of their keys
  for (const auto& run : runs) {
    const auto& [key, record] = *expected++;
    EXPECT_EQ(run.at("problem"), key.cell.problem);
    EXPECT_EQ(run.at("perturbation"), key.cell.perturbation);
    EXPECT_EQ(run.at("solver"), key.cell.solver);
    EXPECT_EQ(run.at("budget_per_variable"), std::to_string(key.cell.budget));
    EXPECT_EQ(run.at("instance"), std::to_string(key.instance));
    EXPECT_EQ(run.at("run"), std::to_string(key.run));
    EXPECT_EQ(run.at("seed"), std::to_string(record.seed));
    EXPECT_EQ(run.at("charged"), std::to_string(record.ledger.charged));
    EXPECT_EQ(read(run.at("seconds")), record.ledger.seconds);
    EXPECT_EQ(run.at("seconds_allowed"), "inf");
    EXPECT_EQ(run.at("failure"),
              record.failure.empty() ? "" : "thrown, with \"quotes\"\\x0ain two lines");
    EXPECT_EQ(run.at("terminations"), "tolerance reached (x2); said, \"enough\" (x1)");
    const double optimality_gap =
        optimality_gap_after(key, std::numeric_limits<std::int64_t>::max());
    EXPECT_EQ(run.at("feasible"), optimality_gap < 1e30 ? "1" : "0");
    EXPECT_EQ(run.at("solved"), optimality_gap <= problem(key.cell.problem).tolerance ? "1" : "0");
    if (optimality_gap < 1e30) {
      EXPECT_EQ(read(run.at("optimality_gap")), optimality_gap);
    } else {
      EXPECT_EQ(run.at("optimality_gap"), "");
    }
    std::string reached;
    for (const Improvement& step : record.trace) {
      if (reached.empty() &&
          optimality_gap_after(key, step.evaluations) <= problem(key.cell.problem).tolerance) {
        reached = std::to_string(step.evaluations);
      }
    }
    EXPECT_EQ(run.at("evaluations_to_solve"), reached);
    EXPECT_EQ(run.at("returned_violation").empty(), !record.returned);
  }
}

TEST_F(Csv, HasEveryImprovement) {
  write_csv(store, {}, out);
  std::map<std::string, RunKey> key_of_number;
  store.each([&](const StoredRun& run) { key_of_number[std::to_string(run.number)] = run.key; });
  std::map<RunKey, std::size_t> seen;
  for (const auto& row : table_in(text_of(out / "improvements.csv"))) {
    const RunKey& key = key_of_number.at(row.at("number"));
    const Improvement& step = records.at(key).trace.at(seen[key]++);
    EXPECT_EQ(row.at("evaluations"), std::to_string(step.evaluations));
    EXPECT_EQ(read(row.at("seconds")), step.seconds);
    EXPECT_EQ(read(row.at("objective")), step.true_values.objective);
    EXPECT_EQ(read(row.at("violation")), step.true_values.violation);
  }
  for (const auto& [key, record] : records) EXPECT_EQ(seen[key], record.trace.size());
}

/// Of 12 variables at most; the made-up runs return the point of their last improvement.
TEST_F(Csv, HasPointsByTheirCoordinates) {
  write_csv(store, {}, out);
  std::map<std::string, RunKey> key_of_number;
  store.each([&](const StoredRun& run) { key_of_number[std::to_string(run.number)] = run.key; });
  std::map<std::string, int> seen;
  for (const auto& row : table_in(text_of(out / "points.csv"))) {
    const RunRecord& record = records.at(key_of_number.at(row.at("number")));
    const bool returned = row.at("point") == "returned";
    const Vector& x = returned ? record.returned->x : record.trace.back().x;
    ++seen[row.at("point")];
    for (Eigen::Index k = 0; k < 12; ++k) {
      const std::string& cell = row.at("x" + std::to_string(k + 1));
      ASSERT_EQ(cell.empty(), k >= x.size());
      if (k < x.size()) {
        EXPECT_EQ(read(cell), x[k]);
      }
    }
  }
  int returned = 0;
  int improved = 0;
  for (const auto& [key, record] : records) {
    returned += record.returned ? 1 : 0;
    improved += record.trace.empty() ? 0 : 1;
  }
  EXPECT_GT(returned, 0);
  EXPECT_EQ(seen["returned"], returned);
  EXPECT_EQ(seen["last improvement"], improved);
}

TEST_F(Csv, HasNoLabelThatIsReadAsAMissingValue) {
  RunRecord record;
  record.failure = "None";
  add({{"wide", "original", "nan", "nlopt-cobyla", 99, "n"}, 1, 0}, record);
  write_csv(store, {}, out);
  const CsvRows runs = table_in(text_of(out / "runs.csv"));
  const auto added = std::ranges::find_if(
      runs, [](const auto& run) { return run.at("budget_per_variable") == "99"; });
  ASSERT_NE(added, runs.end());
  EXPECT_EQ(added->at("perturbation"), "missing-value");
  EXPECT_EQ(added->at("failure"), "'None");
}

/// 24 cells of each problem: 3 solvers, 2 perturbations, 2 budgets; of "profile/5" one more, in
/// which 2 of 4 runs solve it after 3 and 5 evaluations and the others are charged 10 each.
TEST_F(Csv, HasTheRunningTimeOfEveryCell) {
  for (int k = 0; k < 4; ++k) {
    RunRecord record;
    record.ledger.charged = 10;
    if (k < 2) record.trace = {{3 + 2 * k, 0.1, {0.001, 0}, Vector::Zero(5)}};
    if (k == 0) record.returned = ReturnedPoint{Vector::Zero(5), {0.001, 0}};
    if (k > 1) record.trace = {{3 + k, 0.1, {2.0, 0}, Vector::Zero(5)}};
    add({{"profile/5", "original", "plain", "nlopt-cobyla", 7, "n"}, k, 0}, record);
  }
  write_csv(store, {}, out);
  const CsvRows cells = table_in(text_of(out / "running_times.csv"));
  ASSERT_EQ(cells.size(), 4U * 12 + 1);
  const auto added = std::ranges::find_if(
      cells, [](const auto& cell) { return cell.at("budget_per_variable") == "7"; });
  ASSERT_NE(added, cells.end());
  EXPECT_EQ(added->at("solved_share"), "0.5");
  EXPECT_EQ(added->at("expected_running_time"), "14");
  EXPECT_EQ(added->at("returned_solved_share"), "0.25");
  EXPECT_EQ(added->at("returned_expected_running_time"), "33");
}

TEST_F(Csv, HasTheProblemsWithTheirFactors) {
  write_csv(store, {}, out);
  const CsvRows problems = table_in(text_of(out / "problems.csv"));
  ASSERT_EQ(problems.size(), 4U);
  EXPECT_EQ(problems[0].at("best_known"), "-8.25");
  EXPECT_EQ(problems[0].at("friction"), "0.25");
  EXPECT_EQ(problems[2].at("friction"), "") << "asked of no machine";
}

}  // namespace
}  // namespace ricochet::exports
