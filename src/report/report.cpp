#include "src/report/report.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "embedded/page_calibration.h"
#include "embedded/page_comparison.h"
#include "embedded/page_comparison_failures.h"
#include "embedded/page_comparison_family.h"
#include "embedded/page_comparison_machines.h"
#include "embedded/page_comparison_solvers.h"
#include "embedded/page_comparison_view.h"
#include "embedded/page_dynamics.h"
#include "embedded/page_fireworks.h"
#include "embedded/page_impact_test.h"
#include "embedded/page_machine.h"
#include "embedded/page_reproduction.h"
#include "embedded/page_surrogate.h"
#include "embedded/page_verification.h"
#include "ricochet/error.h"
#include "src/core/files.h"
#include "src/core/names.h"
#include "src/report/markdown_page.h"
#include "src/report/page_template.h"
#include "src/report/text.h"

namespace ricochet::report {

namespace {

namespace fs = std::filesystem;

/// In the order of the kinds on a site.
constexpr std::pair<std::string_view, const char*> templates[] = {
    {"reproduction", embedded::page_reproduction},
    {"comparison", embedded::page_comparison},
    {"comparison_family", embedded::page_comparison_family},
    {"comparison_machines", embedded::page_comparison_machines},
    {"comparison_failures", embedded::page_comparison_failures},
    {"comparison_solvers", embedded::page_comparison_solvers},
    {"comparison_view", embedded::page_comparison_view},
    {"advice", embedded::page_machine},
    {"dynamics", embedded::page_dynamics},
    {"surrogate", embedded::page_surrogate},
    {"calibration", embedded::page_calibration},
    {"verification", embedded::page_verification},
    {"impact-test", embedded::page_impact_test},
    {"fireworks", embedded::page_fireworks},
};

constexpr const char* data_file = "data.json";

/// The text of data.json. Pages of Markdown have data that are rounded already.
std::string text_of_data(const std::string& sheet, const Json& data) {
  return is_page_source(sheet) ? json_text(data) : data_text(data, kept_digits(sheet));
}

/// Writes the data of a report, and of its further pages.
void write_data(Json data, const fs::path& folder) {
  if (data.contains("pages")) {
    for (Json& page : data["pages"]) {
      const std::string name = page.at("folder").get<std::string>();
      write_data(std::move(page.at("data")), below(folder, name));
      page = name;
    }
  }
  const std::string sheet = page_template(data.at("report").get<std::string>());
  add_files(folder, {{data_file, text_of_data(sheet, data)}});
}

/// How a report was made, in a sentence; "" if its data do not say.
std::string sentence_of(const Json& made) {
  if (!made.contains("date") || !made.contains("version")) return "";
  const double seconds = made.value("seconds", 0.0);
  const std::string processor = made.value("processor", "");
  return fmt::format("Made on {} by ricochet {} ({}) in {:.{}f} s, with {}{}.",
                     made.at("date").get<std::string>(), made.at("version").get<std::string>(),
                     made.value("compiler", ""), seconds, seconds < 10 ? 1 : 0,
                     counted(made.value("threads", 1), "thread"),
                     processor.empty() ? "" : " on " + processor);
}

void add_made(const Json& made, Results& results) {
  for (const auto& [name, value] : made.items()) {
    if (value.is_string()) results.set("made." + name, value.get<std::string>());
    if (value.is_number()) results.set("made." + name, value.get<double>());
    if (value.is_boolean()) results.set("made." + name, value.get<bool>());
  }
}

/// `made`: how the report was made. Its pages say so at their foot, for tables of seconds need it.
WrittenReport draw_markdown_page(PageSource page, const Json& data, const Json& made,
                                 const fs::path& folder) {
  Results results = results_in(data);
  add_made(made, results);
  if (const std::string foot = sentence_of(made); !foot.empty()) {
    results.set("made", foot);
    page.text += "\n\n{{made}}\n";
  }
  auto [files, failures] = page_files(page, results);
  files[data_file] = json_text(data);
  replace_files(folder, files);
  return {terminal_text(page, results), std::move(failures)};
}

WrittenReport draw_page(Json data, const Json& made, const fs::path& folder) {
  const std::string sheet = page_template(data.at("report").get<std::string>());
  if (is_page_source(sheet)) return draw_markdown_page(page_source(sheet), data, made, folder);
  DrawnPage drawing = drawn(sheet, data, Mismatch::costs_its_chart);
  FileSet files = std::move(drawing.tables);
  if (drawing.headline.version > 0) data["headline"] = std::move(drawing.headline);
  files[data_file] = data_text(data, kept_digits(sheet));
  add_files(folder, files);
  return {drawing.epilogue, write_page(drawing.page, folder, std::move(files))};
}

/// A std::logic_error whose message names the file.
class MismatchError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// The folders of further pages, below that of the report.
std::vector<std::string> pages_of(const Json& data) {
  auto pages = data.value("pages", std::vector<std::string>());
  for (const std::string& page : pages) {
    if (!is_name(page))
      throw std::logic_error("pages: " + Json(page).dump() + " is no folder's name");
  }
  return pages;
}

/// `made`: how the report was made to which this further page belongs.
WrittenReport redraw(const fs::path& from, const Json& made, const fs::path& folder) {
  const fs::path file = from / data_file;
  const std::string text = text_of_file(file);
  std::vector<std::string> failures;
  try {
    Json data = data_in(text);
    const Json own = data.value("made", made);
    for (const std::string& name : pages_of(data)) {
      const WrittenReport further = redraw(from / name, own, below(folder, name));
      failures.insert(failures.end(), further.failures.begin(), further.failures.end());
    }
    WrittenReport written = draw_page(std::move(data), own, folder);
    for (std::string& line : written.failures) line = file.string() + ": " + line;
    written.failures.insert(written.failures.begin(), failures.begin(), failures.end());
    return written;
  } catch (const Json::exception& error) {
    throw InputError(
        fmt::format("{}: must be the data of a report: {}", file.string(), error.what()));
  } catch (const MismatchError&) {
    throw;
  } catch (const std::logic_error& error) {
    throw MismatchError(
        fmt::format("{}: must be the data of a report: {}", file.string(), error.what()));
  }
}

}  // namespace

WrittenReport write_report(const Json& data, const fs::path& folder) {
  write_data(data, folder);
  // The report is drawn from the data as they were stored, not as they were computed.
  return redraw_report(folder, folder);
}

WrittenReport redraw_report(const fs::path& from, const fs::path& folder) {
  return redraw(from, Json::object(), folder);
}

std::string page_template(const std::string& name) {
  std::string known;
  for (const auto& [own, text] : templates) {
    if (own == name) return text;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", own);
  }
  throw std::logic_error(
      fmt::format("report \"{}\": there is no such report; allowed: {}", name, known));
}

std::vector<std::string> page_names() {
  std::vector<std::string> names;
  for (const auto& [name, text] : templates) names.emplace_back(name);
  return names;
}

Results results_of(const Json& data) {
  Results results = results_in(data);
  add_made(data.value("made", Json::object()), results);
  return results;
}

std::vector<ReportKind> report_kinds() {
  std::vector<ReportKind> kinds;
  for (const auto& [name, text] : templates) {
    if (is_page_source(text)) {
      const auto keys = page_source(text).keys;
      if (keys.contains("command"))
        kinds.push_back({std::string(name), keys.at("group"), keys.at("label"), keys.at("question"),
                         keys.at("command")});
      continue;
    }
    const toml::table file = toml::parse(text);
    const toml::table* headline = file["headline"].as_table();
    if (headline == nullptr || !headline->contains("command")) continue;
    const TemplatePart part(*headline);
    kinds.push_back({std::string(name), part.text("group"), part.text("label"),
                     part.text("question"), part.text("command")});
  }
  return kinds;
}

}  // namespace ricochet::report
