#include "src/site/found_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <system_error>

#include "src/report/record_table.h"

namespace ricochet::site {

namespace fs = std::filesystem;

namespace {

/// A contest has each family on a page of its own: adds them to it as `groups`.
void add_families(Json& data, const fs::path& folder) {
  for (const Json& page : data.value("pages", Json::array())) {
    std::ifstream stream(folder / page.get<std::string>() / "data.json", std::ios::binary);
    const Json family = report::unpacked(Json::parse(stream, nullptr, false));
    if (!family.is_object() || family.value("report", Json()) != "contest_family") continue;
    data["groups"].push_back(family);
  }
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
    std::ifstream stream(site / folder / "data.json", std::ios::binary);
    Json parsed = report::unpacked(Json::parse(stream, nullptr, false));
    if (!parsed.is_object()) continue;
    add_families(parsed, site / folder);
    data[folder] = std::move(parsed);
  }
  std::vector<FoundReport> reports;
  for (const ReportKind& kind : report_kinds()) {
    for (const auto& [folder, parsed] : data) {
      if (parsed.value("report", Json()) == kind.name) reports.push_back({folder, parsed, kind});
    }
  }
  return reports;
}

const FoundReport* first_of(const std::vector<FoundReport>& reports, const std::string& kind) {
  const auto found = std::find_if(reports.begin(), reports.end(),
                                  [&](const FoundReport& r) { return r.kind.name == kind; });
  return found == reports.end() ? nullptr : &*found;
}

std::string label_of(const FoundReport& report) {
  if (report.folder == report.kind.name) return report.kind.label;
  return fmt::format("{}: {}", report.kind.label, report.folder);
}

}  // namespace ricochet::site
