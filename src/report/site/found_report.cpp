#include "src/report/site/found_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <map>
#include <stdexcept>
#include <system_error>

#include "ricochet/error.h"
#include "src/core/name.h"
#include "src/core/text_file.h"
#include "src/report/data_text.h"
#include "src/report/page_template.h"

namespace ricochet::site {
namespace {

namespace fs = std::filesystem;

/// Reads the data of a folder. Nothing if they cannot be read.
std::optional<Json> data_of(const fs::path& folder) {
  try {
    return report::data_in(text_of_file(folder / "data.json"));
  } catch (const InputError&) {
    return std::nullopt;
  } catch (const Json::exception&) {
    return std::nullopt;
  } catch (const std::logic_error&) {  // nested too deeply
    return std::nullopt;
  }
}

/// Reads a struct at a key. Nothing if it is missing or of another type.
template <class T>
std::optional<T> read(const Json& data, const char* key) {
  try {
    return data.at(key).get<T>();
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

/// Reads the headline with the parts repeated from the page. Nothing if the data are of another
/// version.
std::optional<report::Headline> headline_of(const Json& data) {
  const auto kept = read<report::Headline>(data, "headline");
  if (!kept || kept->version != report::headline_version) return std::nullopt;
  try {
    return report::headline_in(report::page_template(data.at("report")), data);
  } catch (const std::exception&) {  // the template needs data that are missing
    return std::nullopt;
  }
}

/// The names of further pages; those that may lead out of the folder are left out.
std::vector<std::string> pages_in(const Json& data) {
  auto pages = read<std::vector<std::string>>(data, "pages").value_or(std::vector<std::string>());
  std::erase_if(pages, [](const std::string& page) { return !is_name(page); });
  return pages;
}

FoundReport found(const fs::path& folder, const report::ReportKind& kind, Json data) {
  FoundReport report{folder.filename().string(), kind, read<Made>(data, "made").value_or(Made{}),
                     headline_of(data),          {},   {}};
  const std::vector<std::string> pages = pages_in(data);
  report.data = std::move(data);
  for (const std::string& page : pages) {
    Json own = data_of(folder / page).value_or(Json::object());
    std::vector<std::string> further = pages_in(own);
    report.pages.push_back({page, headline_of(own), std::move(own), std::move(further)});
  }
  return report;
}

/// The data in the subfolders, except for those of sites; nothing where they cannot be read.
std::map<std::string, std::optional<Json>> data_below(const fs::path& site) {
  std::map<std::string, std::optional<Json>> all;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(site, none)) {
    if (!fs::is_regular_file(entry.path() / "data.json", none)) continue;
    std::optional<Json> data = data_of(entry.path());
    if (data && data->is_object() && data->value("report", Json()) == "site") continue;
    all[entry.path().filename().string()] = std::move(data);
  }
  return all;
}

}  // namespace

std::vector<std::string> folders_of_data(const fs::path& site) {
  std::vector<std::string> folders;
  for (const auto& [folder, data] : data_below(site)) folders.push_back(folder);
  return folders;
}

std::vector<FoundReport> found_reports(const fs::path& site) {
  const std::map<std::string, std::optional<Json>> data = data_below(site);
  std::vector<FoundReport> reports;
  for (const report::ReportKind& kind : report::report_kinds()) {
    for (const auto& [folder, own] : data) {
      if (!own || !own->is_object()) continue;
      if (own->value("report", Json()) == kind.name) {
        reports.push_back(found(site / folder, kind, *own));
      }
    }
  }
  return reports;
}

std::string label_of(const FoundReport& report) {
  if (report.folder == report.kind.name) return report.kind.label;
  return fmt::format("{}: {}", report.kind.label, report.folder);
}

bool holds(const std::optional<report::Headline>& headline, const std::string& what) {
  return headline && std::ranges::count(headline->holds, what) > 0;
}

}  // namespace ricochet::site
