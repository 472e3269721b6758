#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "src/report/json.h"
#include "src/site/report_kind.h"

namespace ricochet::site {

using report::Json;

/// A report in a folder of a site.
struct FoundReport {
  std::string folder;  ///< its name, beside the front page
  Json data;           ///< its data.json; of a contest with its families' as `groups`
  ReportKind kind;
};

/// The reports in the folders of this folder, in the order of their kinds, then of their names. A
/// folder without the data of a report of a known kind is none.
std::vector<FoundReport> found_reports(const std::filesystem::path& site);

/// The first report of the kind; nothing where there is none.
const FoundReport* first_of(const std::vector<FoundReport>& reports, const std::string& kind);

/// How the navigation calls it: the label of its kind, with its folder where that has another name.
std::string label_of(const FoundReport& report);

}  // namespace ricochet::site
