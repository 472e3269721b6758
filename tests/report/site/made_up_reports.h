#pragma once

#include <fstream>

#include "src/report/json.h"
#include "src/report/site/entries.h"
#include "tests/core/temporary_folder.h"

namespace ricochet::site {

/// The page of a comparison with these data of a family.
inline FoundPage family_page(const Json& data) {
  report::Headline headline;
  headline.holds = {"family"};
  return {data.at("family"), headline, data};
}

/// A report of that kind as it is found, with these data and nothing else. What it says that it
/// holds is read from them.
inline FoundReport made_up(const std::string& kind, Json data, const std::string& folder,
                           std::vector<std::string> holds = {}) {
  data["report"] = kind;
  for (const report::ReportKind& known : report::report_kinds()) {
    if (known.name != kind) continue;
    report::Headline headline;
    headline.version = report::headline_version;
    headline.title = "What " + kind + " found";
    headline.holds = std::move(holds);
    FoundReport report{folder, known, {}, headline, data, {}};
    for (const Json& page : data.value("pages", Json::array())) {
      report.pages.push_back({page.get<std::string>(), {}, Json::object()});
    }
    return report;
  }
  throw std::logic_error(kind);
}

/// Writes the data of a report into a folder of the site.
inline void keep(const std::filesystem::path& site, const std::string& folder, const Json& data) {
  std::filesystem::create_directories(site / folder);
  std::ofstream(site / folder / "data.json") << data.dump();
}

/// The data of a comparison without speed against accuracy; "mine" is from outside.
inline Json small_comparison() {
  return {
      {"runs", 8},
      {"campaign", "compare"},
      {"compared", true},
      {"beaten", Json::array()},
      {"leaders", Json::array()},
      {"answers", Json::array()},
      {"opening", ""},
      {"families", Json::array()},
      {"map", Json::array()},
      {"speed_accuracy", Json::array()},
      {"solvers", {{{"name", "scan"}, {"outside", false}}, {{"name", "mine"}, {"outside", true}}}}};
}

/// Its one family: two solvers, two budgets.
inline Json small_family() {
  const auto rating = [](const char* solver, double best, double rank) {
    return Json{{"solver", solver}, {"formulation", "count"}, {"problems", 2},
                {"never", 0},       {"returned", 0.5},        {"share", 0.75},
                {"lower", 1.0 / 3}, {"upper", 0.9},           {"best", best},
                {"rank", rank}};
  };
  const auto budget = [&](int evaluations) {
    return Json{{"budget", evaluations},
                {"ratings", {rating("scan", 0.8, 1.25), rating("mine", 0.2, 1.75)}},
                {"first",
                 {{{"solver", "scan"},
                   {"formulation", "count"},
                   {"progress",
                    {{{"evaluations", 1.0}, {"share", 0.0}},
                     {{"evaluations", 2.0}, {"share", 0.0}},
                     {{"evaluations", 4.0}, {"share", 0.0}},
                     {{"evaluations", 8.0}, {"share", 0.5}}}}}}}};
  };
  return {{"family", "count"},
          {"problems",
           {{{"problem", "count-C1"}, {"variables", 1}, {"constraints", 0}},
            {{"problem", "count-C2"}, {"variables", 3}, {"constraints", 2}}}},
          {"budgets", {budget(10), budget(100)}},
          {"break_even_families", Json::array()}};
}

/// Both together.
inline FoundReport found_comparison(const Json& data = small_comparison(),
                                    const std::vector<Json>& families = {small_family()}) {
  FoundReport report = made_up("comparison", data, "comparison", {"entries"});
  for (const Json& family : families) report.pages.push_back(family_page(family));
  return report;
}

}  // namespace ricochet::site
