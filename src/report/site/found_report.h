#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "src/report/headline.h"
#include "src/report/report.h"

namespace ricochet::site {

using report::Json;

/// How a report was made, according to its data.json.
struct Made {
  std::optional<std::string> date;
  std::optional<double> seconds;
  std::optional<bool> quick;
};
RICOCHET_JSON(Made, date, seconds, quick);

/// A further page of a report.
struct FoundPage {
  std::string folder;  ///< inside the report's folder
  std::optional<report::Headline> headline;
  Json data;
  std::vector<std::string> pages = {};  ///< folders of pages inside its own
};

/// A report in a folder of a site.
struct FoundReport {
  std::string folder;  ///< its name, in the front page's folder
  report::ReportKind kind;
  Made made;
  std::optional<report::Headline> headline;  ///< nothing if its data are of another version
  Json data;                                 ///< its data.json
  std::vector<FoundPage> pages;
};

/// Returns the subfolders with a data.json that is not of a site, in the order of their names.
std::vector<std::string> folders_of_data(const std::filesystem::path& site);

/// Returns the reports in the subfolders, in the order of their kinds, then of their names. Folders
/// without the data of a known kind of report are ignored.
std::vector<FoundReport> found_reports(const std::filesystem::path& site);

/// Label in the navigation: that of its kind, with its folder if that has another name.
std::string label_of(const FoundReport& report);

/// Returns true if the headline lists these data.
bool holds(const std::optional<report::Headline>& headline, const std::string& what);

}  // namespace ricochet::site
