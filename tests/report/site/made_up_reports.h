#pragma once

#include <fstream>

#include "src/report/json.h"
#include "src/site/found_report.h"
#include "tests/core/temporary_folder.h"

namespace ricochet::site {

/// A report of that kind as it is found, with these data and nothing else.
inline FoundReport made_up(const std::string& kind, Json data, const std::string& folder) {
  data["report"] = kind;
  for (const ReportKind& known : report_kinds()) {
    if (known.name == kind) return {folder, data, known};
  }
  throw std::logic_error(kind);
}

/// Writes the data of a report into a folder of the site.
inline void keep(const std::filesystem::path& site, const std::string& folder, const Json& data) {
  std::filesystem::create_directories(site / folder);
  std::ofstream(site / folder / "data.json") << data.dump();
}

/// A contest of two solvers on one family with two budgets; "mine" is from outside.
inline Json small_contest() {
  const auto rating = [](const char* solver, double best, double rank) {
    return Json{{"solver", solver}, {"form", "count"}, {"questions", 2},   {"never", 0},
                {"found", 0.5},     {"share", 0.75},   {"lower", 1.0 / 3}, {"upper", 0.9},
                {"best", best},     {"rank", rank}};
  };
  const auto budget = [&](int evaluations) {
    return Json{{"budget", evaluations},
                {"ratings", {rating("scan", 0.8, 1.25), rating("mine", 0.2, 1.75)}},
                {"first",
                 {{{"solver", "scan"},
                   {"form", "count"},
                   {"progress",
                    {{{"evaluations", 1.0}, {"share", 0.0}},
                     {{"evaluations", 2.0}, {"share", 0.0}},
                     {{"evaluations", 4.0}, {"share", 0.0}},
                     {{"evaluations", 8.0}, {"share", 0.5}}}}}}}};
  };
  Json leader = rating("scan", 0.8, 1.25);
  leader["family"] = "count";
  leader["budget"] = 100;
  return {
      {"runs", 8},
      {"leaders", {leader}},
      {"groups",
       {{{"family", "count"},
         {"questions",
          {{{"question", "count-C1"}, {"variables", 1}, {"constraints", 0}},
           {{"question", "count-C2"}, {"variables", 3}, {"constraints", 2}}}},
         {"budgets", {budget(10), budget(100)}}}}},
      {"solvers", {{{"name", "scan"}, {"outside", false}}, {{"name", "mine"}, {"outside", true}}}}};
}

}  // namespace ricochet::site
