#include "src/report/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <stdexcept>
#include <vector>

#include "ricochet/error.h"
#include "src/benchmark/experiment/store/store.h"
#include "src/cli/commands.h"
#include "src/cli/stored_runs.h"
#include "src/core/folder_lock.h"
#include "src/core/one_line.h"
#include "src/core/text_file.h"
#include "src/core/warning.h"
#include "src/report/data_text.h"
#include "src/report/json.h"
#include "src/report/site/site.h"

namespace ricochet::cli {
namespace {

struct ReportOptions {
  std::string from;
  std::string out;  ///< empty: where the reports are
};

/// Says if the store beside a report has other runs than those of the report, such as after an edit
/// of a user's solver.
void warn_of_other_runs(const std::filesystem::path& folder) {
  const std::filesystem::path store = folder / "runs.sqlite";
  if (!std::filesystem::exists(folder / "data.json") || !std::filesystem::exists(store)) return;
  try {
    const report::Json data = report::data_in(text_of_file(folder / "data.json"));
    if (!data.contains("digest")) return;
    const Store runs = Store::open(store, Store::For::reading);
    told_completeness(runs, store.string());
    if (runs.digest() == data["digest"]) return;
    warn(fmt::format(
        "{}: has other runs than this report: make the report again by the command that "
        "made it",
        store.string()));
  } catch (const InputError& error) {
    warn(fmt::format("the runs beside the report are not read: {}", error.what()));
  } catch (const report::Json::exception&) {
    return;  // drawing the report says so
  }
}

/// Says what it has drawn. Returns a line, which begins with a file, for all that could not be
/// drawn.
std::vector<std::string> drawn_again(const std::string& from, const std::string& out) {
  const std::string page =
      one_line((std::filesystem::absolute(out) / "index.html").lexically_normal().string());
  if (const auto failures = site::redraw_site(from, out)) {
    fmt::print("The reports: {}\n", page);
    return *failures;
  }
  std::vector<std::string> failures = report::redraw_report(from, out).failures;
  const std::vector<std::string> above = site::write_site_above(out);
  failures.insert(failures.end(), above.begin(), above.end());
  fmt::print("The report: {}\n", page);
  return failures;
}

int draw_again(const ReportOptions& options) {
  const std::string& from = options.from;
  const std::string& folder = options.out.empty() ? from : options.out;
  if (std::filesystem::is_regular_file(from)) {
    throw InputError(fmt::format("{}: must be a folder, that of a report's data.json", from));
  }
  const FolderLock alone(folder);
  std::vector<std::string> failures;
  warn_of_other_runs(from);
  try {
    failures = drawn_again(from, folder);
  } catch (const std::logic_error& error) {  // the data do not fit the template
    const std::string reason = error.what();
    throw InputError(reason.starts_with(from) ? reason : from + ": " + reason);
  } catch (const report::Json::exception& error) {
    throw InputError(fmt::format("{}: is no data of a report: {}", from, error.what()));
  }
  if (!failures.empty()) throw InputError(fmt::format("{}", fmt::join(failures, "; ")));
  return 0;
}

}  // namespace

void add_report(CommandLine& line) {
  CLI::App* command =
      line.add("report", "Draw a report again from its data, or all reports of a folder",
               "  ricochet report reports/reproduction\n"
               "  ricochet report reports\n"
               "  ricochet report reports/reference --out elsewhere");
  const auto options = std::make_shared<ReportOptions>();
  command->add_option("folder", options->from, "Folder of data.json, or of the reports")
      ->type_name("FOLDER")
      ->required();
  command->add_option("--out", options->out, "Another folder for the pages")->type_name("FOLDER");
  line.on_call(command, [options] { return draw_again(*options); });
}

}  // namespace ricochet::cli
