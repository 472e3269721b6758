#include "src/report/site/entries.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <map>
#include <set>
#include <stdexcept>
#include <system_error>

#include "ricochet/error.h"
#include "src/core/files.h"
#include "src/core/names.h"
#include "src/report/markdown_page.h"
#include "src/report/report_files.h"
#include "src/report/text.h"

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

/// What the page says of itself. Nothing if its data are of another version.
std::optional<Headline> headline_of(const Json& data) {
  try {
    const auto page = report::page_source(report::page_template(data.at("report")));
    const report::Results results = report::results_of(data);
    const auto key = [&](const char* name) {
      const auto found = page.keys.find(name);
      return found == page.keys.end() ? "" : report::filled_line(found->second, results);
    };
    Headline headline{report::title_of(page, results), key("finding"), key("made_by"), "", ""};
    if (!page.keys.contains("command")) {
      headline.group = key("group");
      headline.label = key("label");
    }
    return headline;
  } catch (const std::exception&) {  // there is no such page, or it needs data that are missing
    return std::nullopt;
  }
}

/// The names of further pages; those that may lead out of the folder are left out.
std::vector<std::string> pages_in(const Json& data) {
  auto pages = read<std::vector<std::string>>(data, "pages").value_or(std::vector<std::string>());
  std::erase_if(pages, [](const std::string& page) { return !is_name(page); });
  return pages;
}

Made made_of(const Json& data) {
  Made made;
  const Json own = data.is_object() ? data.value("made", Json::object()) : Json::object();
  made.date = read<std::string>(own, "date");
  made.version = read<std::string>(own, "version");
  made.compiler = read<std::string>(own, "compiler");
  made.seconds = read<double>(own, "seconds");
  made.quick = read<bool>(own, "quick");
  made.reference = read<bool>(own, "reference").value_or(false);
  return made;
}

/// Nothing if they cannot be read.
std::optional<report::Results> results_of(const Json& data) {
  try {
    return report::results_of(data);
  } catch (const std::exception&) {
    return {};
  }
}

FoundReport found(const fs::path& folder, const report::ReportKind& kind, Json data) {
  FoundReport report{folder.filename().string(), kind, made_of(data), headline_of(data), {}};
  report.results = results_of(data);
  const std::vector<std::string> pages = pages_in(data);
  report.data = std::move(data);
  for (const std::string& page : pages) {
    const Json own = data_of(folder / page).value_or(Json::object());
    report.pages.push_back({page, headline_of(own)});
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

std::set<std::string> kinds_computed(const std::vector<FoundReport>& reports) {
  std::set<std::string> kinds;
  for (const FoundReport& report : reports)
    if (!report.made.reference) kinds.insert(report.kind.name);
  return kinds;
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
  std::erase_if(reports, [computed = kinds_computed(reports)](const FoundReport& report) {
    return report.made.reference && computed.contains(report.kind.name);
  });
  return reports;
}

namespace {

/// Copies the data of a report, and of its pages.
void copy_data(const fs::path& from, const fs::path& to, const Json& data) {
  for (const std::string& page : pages_in(data))
    copy_data(from / page, below(to, page), data_of(from / page).value());
  report::add_files(to, {{"data.json", report::json_text(data)}});
}

}  // namespace

std::vector<std::string> complete(const fs::path& site, const fs::path& reference) {
  const std::set<std::string> computed = kinds_computed(found_reports(site));
  std::vector<std::string> failures;
  for (const FoundReport& report : found_reports(reference)) {
    const fs::path folder = below(site, report.folder);
    const auto there = data_of(folder);
    std::error_code none;
    const bool is_other = there ? !made_of(*there).reference : fs::exists(folder, none);
    if (is_other || computed.contains(report.kind.name)) continue;
    Json data = report.data;
    data["made"]["reference"] = true;
    if (there && *there == data && fs::exists(folder / "index.html", none)) continue;
    copy_data(reference / report.folder, folder, data);
    const auto written = report::redraw_report(folder, folder);
    failures.insert(failures.end(), written.failures.begin(), written.failures.end());
  }
  return failures;
}

std::optional<fs::path> reference_folder() {
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none).parent_path();
  fs::path folder = (program / "../../../../reports/reference").lexically_normal();
  if (!fs::is_directory(folder, none)) return {};
  return folder;
}

std::string label_of(const FoundReport& report) {
  if (report.folder == report.kind.name) return report.kind.label;
  return fmt::format("{}: {}", report.kind.label, report.folder);
}

}  // namespace ricochet::site
