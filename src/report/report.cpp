#include "src/report/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "embedded/pages.h"
#include "ricochet/error.h"
#include "src/core/files.h"
#include "src/core/names.h"
#include "src/report/markdown_page.h"
#include "src/report/report_files.h"
#include "src/report/text.h"

namespace ricochet::report {

namespace {

namespace fs = std::filesystem;

constexpr const char* data_file = "data.json";

/// Writes the data of a report, and of its further pages.
void write_data(Json data, const fs::path& folder) {
  if (data.contains("pages")) {
    for (Json& page : data["pages"]) {
      const std::string name = page.at("folder").get<std::string>();
      write_data(std::move(page.at("data")), below(folder, name));
      page = name;
    }
  }
  add_files(folder, {{data_file, json_text(data)}});
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

/// `made`: how the report was made. Its pages say so at their foot, for tables of seconds need it,
/// and below the title if that was not on this machine.
WrittenReport draw_page(const Json& data, const Json& made, const fs::path& folder) {
  PageSource page = page_source(page_template(data.at("report").get<std::string>()));
  Results results = results_in(data);
  add_made(made, results);
  if (made.value("reference", false)) {
    results.open = true;  // it may be older than this program's pages
    const std::size_t title = page.text.find('\n', page.text.find("# "));
    page.text.insert(
        std::min(title, page.text.size()),
        fmt::format("\n\n*Of the committed reference, computed on {}: this machine has "
                    "not computed it.*",
                    made.value("date", "an unknown date")));
  }
  if (const std::string foot = sentence_of(made); !foot.empty()) {
    results.set("made", foot);
    page.text += "\n\n{{made}}\n";
  }
  auto [files, failures] = page_files(page, results);
  files[data_file] = json_text(data);
  replace_files(folder, files);
  return {terminal_text(page, results), std::move(failures)};
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
    const Json data = data_in(text);
    Json own = made;
    own.update(data.value("made", Json::object()));
    for (const std::string& name : pages_of(data)) {
      const WrittenReport further = redraw(from / name, own, below(folder, name));
      failures.insert(failures.end(), further.failures.begin(), further.failures.end());
    }
    WrittenReport written = draw_page(data, own, folder);
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
  for (const auto& [own, text] : embedded::pages) {
    if (own == name) return text;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", own);
  }
  throw std::logic_error(
      fmt::format("report \"{}\": there is no such report; allowed: {}", name, known));
}

Results results_of(const Json& data) {
  Results results = results_in(data);
  add_made(data.value("made", Json::object()), results);
  return results;
}

std::vector<ReportKind> report_kinds() {
  std::vector<ReportKind> kinds;
  for (const auto& [name, text] : embedded::pages) {
    const auto keys = page_source(text).keys;
    if (keys.contains("command"))
      kinds.push_back(
          {name, keys.at("group"), keys.at("label"), keys.at("question"), keys.at("command")});
  }
  return kinds;
}

}  // namespace ricochet::report
