#include "src/report/site/found_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <fstream>
#include <set>
#include <system_error>

#include "src/report/page_template.h"
#include "src/report/record_table.h"

namespace ricochet::site {
namespace {

namespace fs = std::filesystem;

/// Reads the data of a folder. Nothing if it has no JSON object.
std::optional<Json> data_of(const fs::path& folder) {
  std::ifstream stream(folder / "data.json", std::ios::binary);
  Json data = report::unpacked(Json::parse(stream, nullptr, false));
  return data.is_object() ? std::optional(std::move(data)) : std::nullopt;
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

FoundReport found(const fs::path& folder, const report::ReportKind& kind, Json data) {
  FoundReport report{folder.filename().string(), kind, read<Made>(data, "made").value_or(Made{}),
                     headline_of(data),          {},   {}};
  const auto pages = read<std::vector<std::string>>(data, "pages");
  report.data = std::move(data);
  for (const std::string& page : pages.value_or(std::vector<std::string>{})) {
    Json own = data_of(folder / page).value_or(Json::object());
    report.pages.push_back({page, headline_of(own), std::move(own)});
  }
  return report;
}

}  // namespace

std::vector<FoundReport> found_reports(const fs::path& site) {
  std::set<std::string> folders;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(site, none)) {
    if (fs::is_regular_file(entry.path() / "data.json", none)) {
      folders.insert(entry.path().filename().string());
    }
  }
  std::map<std::string, Json> data;
  for (const std::string& folder : folders) {
    if (auto own = data_of(site / folder)) data[folder] = std::move(*own);
  }
  std::vector<FoundReport> reports;
  for (const report::ReportKind& kind : report::report_kinds()) {
    for (const auto& [folder, own] : data) {
      if (own.value("report", Json()) == kind.name) {
        reports.push_back(found(site / folder, kind, own));
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
