#pragma once

#include <filesystem>
#include <string>

#include "src/report/json.h"

namespace ricochet::report {

/// Writes a report into a folder, which is made if missing: data.json, the rows of every table as
/// CSV, and the page that the template data["report"] makes of them, see write_page. A list
/// data["pages"] of {"folder", "data"} makes further pages, each with data of its own, in folders
/// beside; only their names are kept in its place. Returns the template's epilogue. Throws
/// InputError, with nothing changed, where the folder cannot be written; std::logic_error where
/// data and template do not fit.
std::string write_report(Json data, const std::filesystem::path& folder);

/// Draws the report of a folder again, with its further pages, into another or the same, from its
/// data.json alone. Throws
/// InputError where that is missing, or no data of a report.
std::string redraw_report(const std::filesystem::path& from, const std::filesystem::path& folder);

/// The text of a template in reports/templates. Throws InputError for a name that has none.
std::string page_template(const std::string& name);

}  // namespace ricochet::report
