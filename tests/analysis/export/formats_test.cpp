#include "src/analysis/export/formats.h"

#include "src/analysis/export/output.h"
#include "src/report/table.h"
#include "tests/analysis/export/exported_store.h"
#include "tests/support/refusals.h"

namespace ricochet::exports {
namespace {

using nlohmann::json;
using testing::IsSupersetOf;

using CsvRow = std::map<std::string, std::string>;

/// The rows of a file, by the grammar of RFC 4180, section 2, with a line feed for its line break.
std::vector<CsvRow> table_in(const fs::path& file) {
  const std::string text = text_of(file);
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
  std::vector<CsvRow> table(rows.size() - 2);
  for (std::size_t k = 0; k < table.size(); ++k) {
    EXPECT_EQ(rows[k + 1].size(), rows[0].size());
    for (std::size_t i = 0; i < rows[0].size(); ++i) table[k][rows[0][i]] = rows[k + 1].at(i);
  }
  return table;
}

using JsonLines = ExportedStore;

TEST_F(JsonLines, HaveEveryRun) {
  write_json(store, {}, out);
  const auto lines = lines_of(text_of(out / "runs.jsonl"));
  ASSERT_EQ(lines.size(), records.size());
  auto next = records.begin();
  for (const std::string& line : lines) {
    const auto& [key, record] = *next++;
    const double gap = optimality_gap_after(key, std::numeric_limits<std::int64_t>::max());
    const double tolerance = problem(key.cell.problem).tolerance;
    json improvements = json::array(), last, returned, solved;
    for (const auto& [evaluations, seconds, values, x] : record.trace) {
      improvements.push_back({evaluations, seconds, values.objective, values.violation});
      last = std::vector(x.begin(), x.end());
      if (solved.is_null() && optimality_gap_after(key, evaluations) <= tolerance) {
        solved = evaluations;
      }
    }
    if (record.returned) {
      const auto& [x, values] = *record.returned;
      returned = {{"objective", values.objective},
                  {"violation", values.violation},
                  {"x", std::vector(x.begin(), x.end())}};
    }
    const std::map<std::string, json> expected = {
        {"/key/problem", key.cell.problem},
        {"/key/perturbation", key.cell.perturbation},
        {"/key/solver", key.cell.solver},
        {"/key/budget_per_variable", key.cell.budget},
        {"/key/instance", key.instance},
        {"/key/run", key.run},
        {"/seed", record.seed},
        {"/failure", record.failure},
        {"/ledger/charged", record.ledger.charged},
        {"/ledger/seconds", record.ledger.seconds},
        {"/evaluations_allowed", record.budget.evaluations},
        {"/seconds_allowed", json()},
        {"/terminations/0", {{"reason", "tolerance reached"}, {"starts", 2}}},
        {"/verdict/feasible", gap < 1e30},
        {"/verdict/optimality_gap", gap < 1e30 ? json(gap) : json()},
        {"/verdict/solved", gap <= tolerance},
        {"/verdict/evaluations_to_solve", solved},
        {"/improvements", improvements},
        {"/last_improvement_x", last},
        {"/returned", returned}};
    const json run = json::parse(line);
    for (const auto& [at, value] : expected) EXPECT_EQ(run.at(json::json_pointer(at)), value) << at;
  }
  const json campaign = json::parse(text_of(out / "campaign.json"));
  EXPECT_EQ(campaign["plan"], description.plan);
  EXPECT_EQ(campaign["problems"][0]["factors"]["disturbance"], 1.0 / 3);
  EXPECT_EQ(campaign["solvers"][2]["name"], description.solvers[2].name);
}

/// A number reads back to the same bits; flags are 0 or 1; what is missing is empty.
std::string csv_cell_of(const json& value) {
  if (value.is_string()) return value;
  if (value.is_boolean()) return value ? "1" : "0";
  if (value.is_number_float()) return fmt::format("{}", value.get<double>());
  return value.is_null() ? "" : value.dump();
}

using Csv = ExportedStore;

TEST_F(Csv, HasWhatTheJsonLinesHave) {
  std::vector<CsvRow> runs, improvements, points;
  const auto add_point = [&](const json& number, const char* point, const json& x) {
    if (x.is_null()) return;
    points.push_back({{"number", csv_cell_of(number)}, {"point", point}});
    for (std::size_t k = 0; k < 12; ++k) {
      points.back()[fmt::format("x{}", k + 1)] = k < x.size() ? csv_cell_of(x[k]) : "";
    }
  };
  write_json(store, {}, out);
  for (const std::string& line : lines_of(text_of(out / "runs.jsonl"))) {
    const json run = json::parse(line);
    const json& number = run["number"];
    CsvRow& row = runs.emplace_back();
    for (const char* group : {"key", "ledger", "verdict"}) {
      for (const auto& [name, value] : run[group].items()) row[name] = csv_cell_of(value);
    }
    for (const char* own : {"number", "seed", "evaluations_allowed", "termination_reason"}) {
      row[own] = csv_cell_of(run[own]);
    }
    row["seconds_allowed"] = "inf";
    row["failure"] = run["failure"] == "" ? "" : "thrown, with \"quotes\"\\x0ain two lines";
    row["terminations"] = "tolerance reached (x2); said \"enough\" (x1)";
    const json returned = run["returned"].is_null() ? json::object() : run["returned"];
    row["returned_objective"] = csv_cell_of(returned.value("objective", json()));
    row["returned_violation"] = csv_cell_of(returned.value("violation", json()));
    add_point(number, "returned", returned.value("x", json()));
    add_point(number, "last improvement", run["last_improvement_x"]);
    for (const json& step : run["improvements"]) {
      improvements.push_back({{"number", csv_cell_of(number)},
                              {"evaluations", csv_cell_of(step[0])},
                              {"seconds", csv_cell_of(step[1])},
                              {"objective", csv_cell_of(step[2])},
                              {"violation", csv_cell_of(step[3])}});
    }
  }
  EXPECT_GT(runs.size(), 0U);
  write_csv(store, {}, made(out / "csv"));
  EXPECT_EQ(table_in(out / "csv" / "runs.csv"), runs);
  EXPECT_EQ(table_in(out / "csv" / "improvements.csv"), improvements);
  EXPECT_EQ(table_in(out / "csv" / "points.csv"), points);
  const auto problems = table_in(out / "csv" / "problems.csv");
  ASSERT_EQ(problems.size(), 4U);
  EXPECT_EQ(problems[0].at("best_known") + " " + problems[0].at("friction"), "-8.25 0.25");
  EXPECT_EQ(problems[2].at("friction"), "") << "asked of no machine";
}

TEST_F(Csv, HasTheRunningTimeOfEveryCell) {
  add_worked_cell("original");
  write_csv(store, {}, out);
  const auto times = table_in(out / "running_times.csv");
  EXPECT_EQ(times.size(), 4U * 12 + 1) << "of each problem 3 solvers, 2 perturbations, 2 budgets";
  EXPECT_THAT(times, Contains(IsSupersetOf(CsvRow{{"budget_per_variable", "7"},
                                                  {"runs", "4"},
                                                  {"failed_runs", "1"},
                                                  {"solved_share", "0.5"},
                                                  {"expected_running_time", "14"},
                                                  {"returned_solved_share", "0.25"},
                                                  {"returned_expected_running_time", "33"}})));
}

TEST_F(JsonLines, AreValidWhateverBytesATextHas) {
  RunRecord record;
  record.failure = "\xff\xfe";
  add({{"wide", "original", "plain", "nlopt-cobyla", 99, "n"}, 1, 0}, record);
  write_json(store, {}, out);
  EXPECT_THAT(lines_of(text_of(out / "runs.jsonl")),
              Each(testing::Truly([](const auto& line) { return json::accept(line); })));
}

using OutputFolderTest = TemporaryFolder;

TEST_F(OutputFolderTest, GetsAllOfItsFilesAtOnce) {
  const fs::path folder = folder_ / "new" / "out";
  OutputFolder out(folder);
  write_file(out.draft() / "a", "1");
  fs::create_directory(out.draft() / "deep");
  write_file(out.draft() / "deep" / "b", "2");
  EXPECT_FALSE(fs::exists(folder / "a"));
  out.commit();
  EXPECT_EQ(text_of(folder / "a") + text_of(folder / "deep" / "b"), "12");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 2);
}

TEST_F(OutputFolderTest, LeavesNoTraceWhereNothingComesOfIt) {
  fs::create_directory(folder_ / "mine");
  for (const char* folder : {"new/out", "mine"}) {
    const OutputFolder out(folder_ / folder);
    write_file(out.draft() / "a", "1");
  }
  EXPECT_EQ(std::distance(fs::recursive_directory_iterator(folder_), {}), 1)
      << "the user's own folder stays";
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
