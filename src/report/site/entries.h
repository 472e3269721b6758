#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "src/report/json.h"
#include "src/report/report.h"
#include "src/report/results.h"

namespace ricochet::site {

using report::Json;

/// How a report was made, according to its data.json.
struct Made {
  std::optional<std::string> date = {}, version = {}, compiler = {};
  std::optional<double> seconds = {};
  std::optional<bool> quick = {};
  bool reference = false;  ///< it is the committed reference's, and not of this machine
};

/// What a page says of itself, for other pages.
struct Headline {
  std::string title;
  std::string finding;       ///< the result, in a sentence
  std::string command;       ///< that made it; empty: that of its kind
  std::string group, label;  ///< in the navigation, of a further page that stands in it by itself
};

/// A further page of a report.
struct FoundPage {
  std::string folder;  ///< inside the report's folder
  std::optional<Headline> headline;
};

/// A report in a folder of a site.
struct FoundReport {
  std::string folder;  ///< its name, in the front page's folder
  report::ReportKind kind;
  Made made;
  std::optional<Headline> headline;  ///< nothing if its data are of another version
  Json data;                         ///< its data.json
  std::vector<FoundPage> pages = {};
  /// What it found; nothing if its data are of another version.
  std::optional<report::Results> results = {};
};

/// Returns the subfolders with a data.json that is not of a site, in the order of their names.
std::vector<std::string> folders_of_data(const std::filesystem::path& site);

/// Returns the reports in the subfolders, in the order of their kinds, then of their names. Folders
/// without the data of a known kind of report are ignored, and so are those of the reference whose
/// kind this machine has computed.
std::vector<FoundReport> found_reports(const std::filesystem::path& site);

/// Draws into a site what the reference has and the site has not computed, see Made::reference, so
/// that the site is whole; a folder that has the same data already, or something else, stays.
/// Returns a line for each chart that could not be drawn.
std::vector<std::string> complete(const std::filesystem::path& site,
                                  const std::filesystem::path& reference);

/// The committed reference, in the source tree of the running program; nothing if the program is
/// installed.
std::optional<std::filesystem::path> reference_folder();

/// Label in the navigation: that of its kind, with its folder if that has another name.
std::string label_of(const FoundReport& report);

}  // namespace ricochet::site
