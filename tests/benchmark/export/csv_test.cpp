#include "src/benchmark/export/csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

#include "src/benchmark/export/csv_row.h"
#include "tests/benchmark/export/exported_store.h"

namespace ricochet::exports {
namespace {

using testing::ElementsAre;

using Table = std::vector<std::map<std::string, std::string>>;

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

Table table_in(const std::string& text) {
  const auto rows = fields_in(text);
  Table table;
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
  const std::vector<std::string> fields = {"",           "plain", "a,b", "\"",      "say \"so\"",
                                           "two\nlines", "a\r",   " ",   ",,\"\",,"};
  EXPECT_THAT(fields_in(csv_row(fields)), ElementsAre(fields));
  EXPECT_EQ(csv_row({"a", "b,c", "d\"e"}), "a,\"b,c\",\"d\"\"e\"\n");
}

TEST(CsvRow, NumbersReadBackToTheSameBits) {
  std::mt19937_64 random(3);
  for (int k = 0; k < 10'000; ++k) {
    const double value = std::bit_cast<double>(random());
    if (std::isnan(value)) continue;
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read(number(value))),
              std::bit_cast<std::uint64_t>(value));
  }
  EXPECT_EQ(number(0.1), "0.1");
  EXPECT_EQ(number(-std::numeric_limits<double>::infinity()), "-inf");
  EXPECT_EQ(number(std::optional<double>()), "");
}

using Csv = ExportedStore;

TEST_F(Csv, HasEveryRunWithItsVerdict) {
  write_csv(store, out);
  const Table runs = table_in(text_of(out / "runs.csv"));
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
  write_csv(store, out);
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

TEST_F(Csv, HasTheProblemsWithTheirFactors) {
  write_csv(store, out);
  const Table problems = table_in(text_of(out / "problems.csv"));
  ASSERT_EQ(problems.size(), 4U);
  EXPECT_EQ(problems[0].at("best_known"), "-8.25");
  EXPECT_EQ(problems[0].at("friction"), "0.25");
  EXPECT_EQ(problems[2].at("friction"), "") << "asked of no machine";
}

}  // namespace
}  // namespace ricochet::exports
