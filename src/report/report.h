#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "src/report/json.h"
#include "src/report/results.h"

namespace ricochet::report {

/// The result of writing a report.
struct [[nodiscard]] WrittenReport {
  std::string epilogue;               ///< what ends the command
  std::vector<std::string> failures;  ///< file and reason of each chart not drawn
};

/// Writes a report into a folder, which is created if needed: data.json, and the files of the page
/// of that name, data["report"], see page_files(). A list data["pages"] of {"folder", "data"} makes
/// further pages from their own data, in subfolders; data.json keeps only their names. All
/// data.json are written before anything is drawn. Throws InputError if the folder cannot be
/// written, with nothing changed if the whole folder is affected; std::logic_error if data and page
/// do not match.
WrittenReport write_report(const Json& data, const std::filesystem::path& folder);

/// Draws the report of a folder again from its data.json, with its further pages, into another
/// folder or the same. Throws InputError if data.json is missing or does not hold a report's data.
WrittenReport redraw_report(const std::filesystem::path& from, const std::filesystem::path& folder);

/// A kind of report that a site shows, by the keys of its page.
struct ReportKind {
  std::string name;      ///< as data.json has it in "report"
  std::string group;     ///< word of the navigation under which it stands
  std::string label;     ///< in the navigation
  std::string question;  ///< that it answers
  std::string command;   ///< the command that makes it
};

/// Returns all kinds: the pages that have a command, in the order of a site.
std::vector<ReportKind> report_kinds();

/// The results in the data of a report, with how it was made: made.date, made.seconds, ...
Results results_of(const Json& data);

/// Returns the source of a report's page, see markdown_page.h. Throws std::logic_error for an
/// unknown name.
std::string page_template(const std::string& name);

}  // namespace ricochet::report
