#include "tests/analysis/export/iohanalyzer_check.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "tests/analysis/export/exported_store.h"

namespace ricochet::exports {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Complaints = std::vector<std::string>;

std::set<std::string> keys(const json& object) {
  std::set<std::string> names;
  for (const auto& item : object.items()) names.insert(item.key());
  return names;
}

/// Numbers with single blanks between them; nothing where it is another line.
std::vector<double> numbers(const std::string& line) {
  static const std::regex row("-?[0-9.]+(e[-+]?[0-9]+)?( -?[0-9.]+(e[-+]?[0-9]+)?)*");
  if (!std::regex_match(line, row)) return {};
  std::vector<double> values;
  std::istringstream stream(line);
  for (std::string word; stream >> word;) values.push_back(std::strtod(word.c_str(), nullptr));
  return values;
}

void check_rows(const ReadRun& run, Complaints& complaints) {
  if (run.rows.empty()) return complaints.push_back("a run without rows");
  if (run.rows.front().evaluations != 1) complaints.push_back("first row is not evaluation 1");
  for (std::size_t k = 1; k < run.rows.size(); ++k) {
    if (run.rows[k].evaluations <= run.rows[k - 1].evaluations) {
      complaints.push_back("evaluations do not rise");
    }
    const bool last = k + 1 == run.rows.size();
    if (run.rows[k].raw_y > run.rows[k - 1].raw_y) complaints.push_back("raw_y rises");
    if (run.rows[k].raw_y == run.rows[k - 1].raw_y && !last) complaints.push_back("repeated raw_y");
  }
}

std::vector<ReadRun> read_rows(const fs::path& file, Complaints& complaints) {
  std::vector<ReadRun> runs;
  for (const std::string& line : lines_of(text_of(file))) {
    if (line == "evaluations raw_y time_s gevals") {
      runs.emplace_back();
      continue;
    }
    const auto values = numbers(line);
    if (values.size() != 4) {
      complaints.push_back("a row that is not four numbers: " + line);
    } else if (runs.empty()) {
      complaints.push_back("no header before the first run");
    } else {
      runs.back().rows.push_back(
          {static_cast<std::int64_t>(values[0]), values[1], values[2], values[3]});
    }
  }
  for (const ReadRun& run : runs) check_rows(run, complaints);
  return runs;
}

void check_best(const json& told, const ReadRun& run, Complaints& complaints) {
  if (keys(told) != std::set<std::string>{"instance", "evals", "best"}) {
    return complaints.push_back("a run has other members");
  }
  const json& best = told["best"];
  if (keys(best) != std::set<std::string>{"evals", "y", "x"}) {
    return complaints.push_back("best has not exactly evals, y and x");
  }
  if (run.rows.empty()) return;
  if (told["evals"] != run.rows.back().evaluations) complaints.push_back("evals is not the last");
  const auto first_best = std::find_if(run.rows.begin(), run.rows.end(), [&](const ReadRow& row) {
    return row.raw_y == run.rows.back().raw_y;
  });
  if (best["y"] != first_best->raw_y || best["evals"] != first_best->evaluations) {
    complaints.push_back("best is not that of the rows");
  }
}

void check_head(const json& data, const std::string& file, ReadCase& read, Complaints& complaints) {
  const std::set<std::string> members = {
      "version",   "suite",      "function_id",           "function_name", "maximization",
      "algorithm", "attributes", "experiment_attributes", "scenarios"};
  if (keys(data) != members) return complaints.push_back("other members at the top");
  int version[3] = {};
  std::sscanf(data["version"].get<std::string>().c_str(), "%d.%d.%d", version, version + 1,
              version + 2);
  if (std::vector<int>(version, version + 3) < std::vector<int>{0, 3, 3}) {
    complaints.push_back("version is below 0.3.3");
  }
  if (data["maximization"] != false) complaints.push_back("it is no minimisation");
  if (data["attributes"] != json({"evaluations", "raw_y", "time_s", "gevals"})) {
    complaints.push_back("attributes are not the columns");
  }
  for (const json& attribute : data["experiment_attributes"]) {
    if (attribute.size() != 1 || !attribute.begin()->is_string()) {
      complaints.push_back("an experiment attribute is not one name with one text");
    }
  }
  if (keys(data["algorithm"]) != std::set<std::string>{"name", "info"}) {
    complaints.push_back("algorithm has not name and info");
  }
  read.algorithm = data["algorithm"]["name"];
  read.function = data["function_name"];
  read.function_id = data["function_id"];
  const std::string stem = "f" + std::to_string(read.function_id) + "_" + read.function;
  if (file != "IOHprofiler_" + stem + ".json") complaints.push_back("file has another name");
  const json& scenarios = data["scenarios"];
  if (scenarios.size() != 1) return complaints.push_back("not one scenario");
  read.dimension = scenarios[0]["dimension"];
  if (scenarios[0]["path"] != "data_" + stem + "/IOHprofiler_f" + std::to_string(read.function_id) +
                                  "_DIM" + std::to_string(read.dimension) + ".dat") {
    complaints.push_back("path is not that of the rows");
  }
}

}  // namespace

std::vector<ReadCase> read_iohanalyzer(const fs::path& root, Complaints& complaints) {
  std::vector<ReadCase> cases;
  std::set<int> ids;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const fs::path file = entry.path();
    if (entry.is_directory() || file.extension() == ".dat") continue;
    const bool in_root = file.parent_path() == root;
    if (!in_root || file.extension() != ".json" ||
        !file.filename().string().starts_with("IOHprofiler_f")) {
      complaints.push_back("another file: " + file.filename().string());
      continue;
    }
    const json data = json::parse(text_of(file), nullptr, false);
    if (data.is_discarded()) {
      complaints.push_back("no JSON");
      continue;
    }
    ReadCase read;
    const std::size_t before = complaints.size();
    check_head(data, file.filename(), read, complaints);
    if (!ids.insert(read.function_id).second) complaints.push_back("a function_id twice");
    if (complaints.size() > before) continue;
    const json& scenario = data["scenarios"][0];
    if (!fs::exists(root / scenario["path"])) complaints.push_back("rows are missing");
    read.runs = read_rows(root / scenario["path"], complaints);
    if (read.runs.size() != scenario["runs"].size()) {
      complaints.push_back("not as many runs as in the rows");
      continue;
    }
    for (std::size_t k = 0; k < read.runs.size(); ++k) {
      check_best(scenario["runs"][k], read.runs[k], complaints);
      read.runs[k].instance = scenario["runs"][k].value("instance", 0);
    }
    cases.push_back(read);
  }
  return cases;
}

}  // namespace ricochet::exports
