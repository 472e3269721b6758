#pragma once

#include "src/report/json.h"
#include "src/report/site/entries.h"
#include "tests/support/files.h"

namespace ricochet::site {

/// A report of that kind as it is found, with these data and pages and nothing else.
inline FoundReport made_up(const std::string& kind, Json data, const std::string& folder,
                           const std::vector<std::string>& pages = {}) {
  data["report"] = kind;
  for (const report::ReportKind& known : report::report_kinds()) {
    if (known.name != kind) continue;
    const Headline headline{"What " + kind + " found", "", "", "", ""};
    FoundReport report{folder, known, {}, headline, data};
    for (const std::string& page : pages) report.pages.push_back({page, {}});
    return report;
  }
  throw std::logic_error(kind);
}

/// The same with results.
inline FoundReport made_up(const std::string& kind, report::Results results) {
  FoundReport report = made_up(kind, json_of(results), kind);
  report.results = std::move(results);
  return report;
}

/// Writes the data of a report into a folder of the site.
inline void keep(const fs::path& site, const std::string& folder, const Json& data) {
  write_file(site / folder / "data.json", data.dump());
}

/// A comparison with one family.
inline FoundReport found_comparison() {
  report::Results results;
  results.set("finding", "Found: all.");
  results.set("runs", 8);
  results.set("campaign", "compare");
  results.set("suite", 3);
  results.set("digest", "0123abcd");
  ricochet::Table leaders{
      "leaders", columns_named("family,budget,first,tuned,returned,best,takes,problems,most")};
  leaders.add("count", 100, "scan, count", "", 0.5, 0.8, 2, 2, std::nullopt);
  results.add(std::move(leaders));
  FoundReport report = made_up("comparison", std::move(results));
  report.headline->finding = "Found: all.";
  return report;
}

}  // namespace ricochet::site
