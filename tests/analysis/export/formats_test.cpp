#include "src/analysis/export/formats.h"

#include "src/analysis/export/output.h"
#include "src/report/table.h"
#include "tests/analysis/export/exported_store.h"
#include "tests/support/refusals.h"
#include "tests/support/test.h"

namespace ricochet::exports {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::ElementsAre;

using CsvRow = std::map<std::string, std::string>;

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

std::vector<CsvRow> table_in(const fs::path& file) {
  const auto rows = fields_in(text_of(file));
  std::vector<CsvRow> table(rows.size() - 1);
  for (std::size_t k = 1; k < rows.size(); ++k) {
    EXPECT_EQ(rows[k].size(), rows[0].size());
    for (std::size_t i = 0; i < rows[0].size(); ++i) table[k - 1][rows[0][i]] = rows[k].at(i);
  }
  return table;
}

/// The fields of the row that are in `like`.
CsvRow fields_like(const CsvRow& like, CsvRow row) {
  std::erase_if(row, [&](const auto& field) { return !like.contains(field.first); });
  return row;
}

/// How many rows have these fields.
std::ptrdiff_t rows_like(const CsvRow& fields, const fs::path& file) {
  return std::ranges::count_if(
      table_in(file), [&](const CsvRow& row) { return fields_like(fields, row) == fields; });
}

/// A number as it reads back to the same bits.
std::string in_digits(double x) {
  return fmt::format("{}", x);
}

TEST(CsvRow, ReadsBackToItsFields) {
  const std::vector<std::string> fields = {"", "plain", "a,b", "\"", "say \"so\"", " ", ",,\"\",,"};
  Table table{"fields", columns_named("a,b,c,d,e,f,g")};
  table.add_row({fields.begin(), fields.end()});
  EXPECT_THAT(fields_in(csv_of(table, Lines::rows)), ElementsAre(fields));
}

class Csv : public ExportedStore {
 protected:
  /// The run of each number in the store.
  std::map<std::string, RunKey> keys_by_number() const {
    std::map<std::string, RunKey> keys;
    store.each([&](const StoredRun& run) { keys[std::to_string(run.number)] = run.key; });
    return keys;
  }
};

TEST_F(Csv, HasEveryRunWithItsVerdict) {
  write_csv(store, {}, out);
  const std::vector<CsvRow> runs = table_in(out / "runs.csv");
  ASSERT_EQ(runs.size(), records.size());
  auto next = records.begin();
  for (const CsvRow& run : runs) {
    const auto& [key, record] = *next++;
    const double tolerance = problem(key.cell.problem).tolerance;
    const double gap = optimality_gap_after(key, std::numeric_limits<std::int64_t>::max());
    std::string solved;
    for (const Improvement& step : record.trace) {
      if (solved.empty() && optimality_gap_after(key, step.evaluations) <= tolerance) {
        solved = std::to_string(step.evaluations);
      }
    }
    const CsvRow expected = {
        {"problem", key.cell.problem},
        {"perturbation", key.cell.perturbation},
        {"solver", key.cell.solver},
        {"budget_per_variable", std::to_string(key.cell.budget)},
        {"instance", std::to_string(key.instance)},
        {"run", std::to_string(key.run)},
        {"seed", std::to_string(record.seed)},
        {"charged", std::to_string(record.ledger.charged)},
        {"seconds", in_digits(record.ledger.seconds)},
        {"seconds_allowed", "inf"},
        {"failure", record.failure.empty() ? "" : "thrown, with \"quotes\"\\x0ain two lines"},
        {"terminations", "tolerance reached (x2); said, \"enough\" (x1)"},
        {"feasible", gap < 1e30 ? "1" : "0"},
        {"solved", gap <= tolerance ? "1" : "0"},
        {"optimality_gap", gap < 1e30 ? in_digits(gap) : ""},
        {"evaluations_to_solve", solved},
        {"returned_objective",
         record.returned ? in_digits(record.returned->true_values.objective) : ""},
        {"returned_violation",
         record.returned ? in_digits(record.returned->true_values.violation) : ""}};
    EXPECT_EQ(fields_like(expected, run), expected);
  }
}

TEST_F(Csv, HasEveryImprovement) {
  write_csv(store, {}, out);
  const auto keys = keys_by_number();
  std::map<RunKey, std::size_t> seen;
  for (const CsvRow& row : table_in(out / "improvements.csv")) {
    const RunKey& key = keys.at(row.at("number"));
    const Improvement& step = records.at(key).trace.at(seen[key]++);
    EXPECT_EQ(row, (CsvRow{{"number", row.at("number")},
                           {"evaluations", std::to_string(step.evaluations)},
                           {"seconds", in_digits(step.seconds)},
                           {"objective", in_digits(step.true_values.objective)},
                           {"violation", in_digits(step.true_values.violation)}}));
  }
  for (const auto& [key, record] : records) EXPECT_EQ(seen[key], record.trace.size());
}

TEST_F(Csv, HasPointsByTheirCoordinates) {
  write_csv(store, {}, out);
  std::map<RunKey, std::map<std::string, std::vector<double>>> seen, expected;
  const auto keys = keys_by_number();
  for (const CsvRow& row : table_in(out / "points.csv")) {
    std::vector<double>& x = seen[keys.at(row.at("number"))][row.at("point")];
    for (std::size_t k = 1; k <= 12; ++k) {
      const std::string& cell = row.at("x" + std::to_string(k));
      if (!cell.empty()) x.resize(k), x.back() = std::stod(cell);
    }
  }
  for (const auto& [key, record] : records) {
    if (!record.trace.empty()) {
      const Vector& x = record.trace.back().x;
      expected[key]["last improvement"] = {x.begin(), x.end()};
    }
    if (record.returned) {
      expected[key]["returned"] = {record.returned->x.begin(), record.returned->x.end()};
    }
  }
  EXPECT_EQ(seen, expected);
}

TEST_F(Csv, HasNoLabelThatIsReadAsAMissingValue) {
  RunRecord record;
  record.failure = "None";
  add({{"wide", "original", "nan", "nlopt-cobyla", 99, "n"}, 1, 0}, record);
  write_csv(store, {}, out);
  EXPECT_EQ(
      rows_like(
          {{"budget_per_variable", "99"}, {"perturbation", "missing-value"}, {"failure", "'None"}},
          out / "runs.csv"),
      1);
}

/// 24 cells of each problem, 3 solvers, 2 perturbations, 2 budgets, and the one that is worked.
TEST_F(Csv, HasTheRunningTimeOfEveryCell) {
  add_worked_cell("original");
  write_csv(store, {}, out);
  EXPECT_EQ(table_in(out / "running_times.csv").size(), 4U * 12 + 1);
  EXPECT_EQ(rows_like({{"budget_per_variable", "7"},
                       {"runs", "4"},
                       {"failed_runs", "1"},
                       {"solved_share", "0.5"},
                       {"expected_running_time", "14"},
                       {"returned_solved_share", "0.25"},
                       {"returned_expected_running_time", "33"}},
                      out / "running_times.csv"),
            1);
}

TEST_F(Csv, HasTheProblemsWithTheirFactors) {
  write_csv(store, {}, out);
  const auto problems = table_in(out / "problems.csv");
  ASSERT_EQ(problems.size(), 4U);
  EXPECT_EQ(problems[0].at("best_known") + " " + problems[0].at("friction"), "-8.25 0.25");
  EXPECT_EQ(problems[2].at("friction"), "") << "asked of no machine";
}

using JsonLines = ExportedStore;

TEST_F(JsonLines, HaveEveryRun) {
  write_json(store, {}, out);
  const auto lines = lines_of(text_of(out / "runs.jsonl"));
  ASSERT_EQ(lines.size(), records.size());
  auto next = records.begin();
  for (const std::string& line : lines) {
    const json run = json::parse(line);
    const auto& [key, record] = *next++;
    json improvements = json::array();
    for (const Improvement& step : record.trace) {
      improvements.push_back(
          {step.evaluations, step.seconds, step.true_values.objective, step.true_values.violation});
    }
    json returned;
    if (record.returned) {
      const auto& [x, values] = *record.returned;
      returned = {{"objective", values.objective},
                  {"violation", values.violation},
                  {"x", std::vector<double>(x.begin(), x.end())}};
    }
    const bool solved =
        optimality_gap_after(key, 1'000'000'000) <= problem(key.cell.problem).tolerance;
    const std::map<std::string, json> expected = {
        {"/key/problem", key.cell.problem},
        {"/key/solver", key.cell.solver},
        {"/key/instance", key.instance},
        {"/seed", record.seed},
        {"/failure", record.failure},
        {"/ledger/charged", record.ledger.charged},
        {"/evaluations_allowed", record.budget.evaluations},
        {"/seconds_allowed", json()},
        {"/terminations/0", {{"reason", "tolerance reached"}, {"starts", 2}}},
        {"/verdict/solved", solved},
        {"/improvements", improvements},
        {"/returned", returned}};
    for (const auto& [at, value] : expected) EXPECT_EQ(run.at(json::json_pointer(at)), value) << at;
  }
}

TEST_F(JsonLines, ComeWithTheCampaignAndHowCompleteItIs) {
  Completeness some;
  some.planned = 10;
  some.present = 7;
  some.parts = {{"one", 4, 4}, {"part 2", 6, 3}};
  write_json(store, some, out);
  const json campaign = json::parse(text_of(out / "campaign.json"));
  EXPECT_EQ(campaign["plan"], description.plan);
  EXPECT_EQ(campaign["problems"][0]["factors"]["disturbance"], 1.0 / 3);
  EXPECT_EQ(campaign["solvers"][2]["name"], description.solvers[2].name);
  EXPECT_EQ(campaign["missing"], 3);
  EXPECT_EQ(campaign["parts"][1],
            json({{"part", "part 2"}, {"planned", 6}, {"present", 3}, {"missing", 3}}));
  write_csv(store, some, made(out / "csv"));
  EXPECT_EQ(text_of(out / "csv" / "completeness.csv"),
            "part,planned,present,missing\nall,10,7,3\none,4,4,0\npart 2,6,3,3\n");
}

TEST_F(JsonLines, AreValidWhateverBytesATextHas) {
  RunRecord record;
  record.failure = "\xff\xfe";
  add({{"wide", "original", "plain", "nlopt-cobyla", 99, "n"}, 1, 0}, record);
  write_json(store, {}, out);
  for (const std::string& line : lines_of(text_of(out / "runs.jsonl"))) {
    EXPECT_TRUE(json::accept(line)) << line;
  }
}

using OutputFolderTest = TemporaryFolder;

TEST_F(OutputFolderTest, GetsAllOfItsFilesAtOnce) {
  OutputFolder out(folder_ / "new" / "out");
  write_file(out.draft() / "a", "1");
  fs::create_directory(out.draft() / "deep");
  write_file(out.draft() / "deep" / "b", "2");
  EXPECT_FALSE(fs::exists(folder_ / "new" / "out" / "a"));
  out.commit();
  EXPECT_EQ(text_of(folder_ / "new" / "out" / "a"), "1");
  EXPECT_EQ(text_of(folder_ / "new" / "out" / "deep" / "b"), "2");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "new" / "out"), {}), 2);
}

TEST_F(OutputFolderTest, LeavesNoTraceWhereNothingComesOfIt) {
  {
    const OutputFolder out(folder_ / "new" / "out");
    write_file(out.draft() / "a", "1");
  }
  EXPECT_TRUE(fs::is_empty(folder_));
  fs::create_directory(folder_ / "mine");
  {
    const OutputFolder out(folder_ / "mine");
    write_file(out.draft() / "a", "1");
  }
  EXPECT_TRUE(fs::is_empty(folder_ / "mine")) << "the user's own folder stays";
}

TEST_F(OutputFolderTest, IsRefusedWhereSomethingIs) {
  write_file(folder_ / "file", "mine");
  expect_refusals<InputError, fs::path>(
      [](const fs::path& path) { return OutputFolder{path}.draft(); },
      {{folder_, "must be a folder that is new or empty"},
       {folder_ / "file", "must be a folder that is new or empty"},
       {folder_ / "file" / "below", "/file"}});
  EXPECT_THROW(write_file(folder_ / "file", "other"), InputError) << "no file twice";
  EXPECT_EQ(text_of(folder_ / "file"), "mine");
}

}  // namespace
}  // namespace ricochet::exports
