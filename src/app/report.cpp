#include "src/app/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "ricochet/error.h"
#include "src/analysis/comparison/order.h"
#include "src/analysis/export/formats.h"
#include "src/analysis/export/output.h"
#include "src/app/campaign.h"
#include "src/app/command_line.h"
#include "src/core/files.h"
#include "src/core/names.h"
#include "src/core/progress.h"
#include "src/experiment/store.h"
#include "src/report/json.h"
#include "src/report/report.h"
#include "src/report/site/site.h"
#include "src/report/text.h"

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
    const report::Json values = data.value("values", report::Json::object());
    if (!values.contains("digest")) return;
    const Store runs = Store::open(store, Store::For::reading);
    told_completeness(runs, store.string());
    if (runs.digest() == values["digest"]) return;
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
  const std::vector<std::string> above = site::write_site_above(out, site::reference_folder());
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
  add_value(command, "folder", options->from, "Folder of data.json, or of the reports", "FOLDER")
      ->required();
  add_value(command, "--out", options->out, "Another folder for the pages", "FOLDER");
  line.on_call(command, [options] { return draw_again(*options); });
}

namespace {

struct SiteOptions {
  std::string from = "reports/reference";
  std::string out;
};

int write_site(const SiteOptions& options) {
  const site::Publication written = site::publish_site(options.from, options.out);
  const auto page = (std::filesystem::absolute(options.out) / "index.html").lexically_normal();
  fmt::print("The site: {}\n{}, {:.1f} MB\n", one_line(page.string()),
             report::counted(written.pages, "page"), static_cast<double>(written.bytes) / 1e6);
  if (!written.failures.empty()) {
    throw InputError(fmt::format("{}", fmt::join(written.failures, "; ")));
  }
  return 0;
}

}  // namespace

void add_site(CommandLine& line) {
  CLI::App* command =
      line.add("site", "Write all reports and documents as a site for a static host",
               "  ricochet site --out pages\n"
               "  ricochet site reports --out pages");
  const auto options = std::make_shared<SiteOptions>();
  add_value(command, "folder", options->from, "Folder of the reports", "FOLDER");
  add_value(command, "--out", options->out, "Folder for the site: new, empty or an earlier site",
            "FOLDER")
      ->required();
  line.on_call(command, [options] { return write_site(*options); });
}

namespace {

struct ExportOptions {
  std::string store;  ///< SQLite file
  std::string format;
  std::string out;  ///< folder, empty or missing
};

/// Adds the files about ranked entries, or warns why they or some solvers are left out.
void add_rated(const exports::Format& format, const Store& store,
               const std::filesystem::path& folder) {
  try {
    const FinishedCampaign finished = finished_campaign(store);
    std::vector<std::string> unranked;
    for (const StoredSolver& solver : store.description().solvers) {
      const auto& ranked = finished.campaign.solvers();
      if (std::ranges::find(ranked, solver.name, &Solver::name) == ranked.end()) {
        unranked.push_back(one_line(solver.name));
      }
    }
    if (!unranked.empty()) {
      warn(
          fmt::format("ranked without {}: this build has no such solver; the report that `run` or "
                      "`compare` wrote beside the store ranks all",
                      fmt::join(unranked, ", ")));
    }
    format.write_rated(studies::comparison::rated_families(finished.campaign, finished.results),
                       folder);
  } catch (const InputError& error) {
    warn(fmt::format("entries are not ranked: {}", error.what()));
  }
}

/// What is known of a store whose plan this build cannot read: its runs, and that some may be
/// missing.
Completeness unknown_plan(const Store& store) {
  Completeness known;
  known.planned = known.present = store.size();
  for (const StoredSolver& solver : store.description().solvers) {
    known.unknown_solvers.push_back(solver.name);
  }
  return known;
}

int export_store(const ExportOptions& options) {
  const exports::Format format = named(exports::all_formats(), options.format, "format",
                                       [](const exports::Format& known) { return known.name; });
  const std::string file = archive_named(options.store);
  const Store store = Store::open(file, Store::For::reading);
  warn_of_missing_runs(file);
  exports::OutputFolder out(options.out);
  const auto completeness = told_completeness(store, file);
  format.write(store, completeness.value_or(unknown_plan(store)), out.draft());
  if (format.write_rated) add_rated(format, store, out.draft());
  out.commit();
  fmt::print("{}: {}\n", counted_runs(store, completeness), one_line(options.out));
  return 0;
}

}  // namespace

void add_export(CommandLine& line) {
  std::string examples =
      "  ricochet export mine/runs.sqlite --format csv --out tables\n"
      "  ricochet export mine/runs.sqlite --format iohanalyzer --out for-iohanalyzer\n"
      "Formats:\n";
  std::vector<std::string> names;
  for (const exports::Format& format : exports::all_formats()) {
    names.push_back(format.name);
    examples += fmt::format("  {:11}  {}\n", format.name, format.about);
  }
  CLI::App* command =
      line.add("export", "Export a store: tables, IOHanalyzer, COCO",
               examples + "For Parquet, convert the CSV files, for instance with DuckDB.");
  const auto options = std::make_shared<ExportOptions>();
  add_value(command, "store", options->store, "A store, runs.sqlite", "FILE")->required();
  add_value(command, "--format", options->format, "One of these formats",
            fmt::format("FORMAT:{{{}}}", fmt::join(names, ",")))
      ->required();
  add_value(command, "--out", options->out, "Folder, new or empty", "FOLDER")->required();
  line.on_call(command, [options] { return export_store(*options); });
}

namespace {

/// Returns true if both are, or would be, the same regular file.
bool are_same(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code none;
  if (std::filesystem::exists(a, none) && !std::filesystem::is_regular_file(a, none)) return false;
  return std::filesystem::equivalent(a, b, none) ||
         std::filesystem::weakly_canonical(a, none) == std::filesystem::weakly_canonical(b, none);
}

}  // namespace

void refuse_same_files(const std::vector<AskedFile>& asked,
                       const std::vector<std::string>& inputs) {
  std::vector<std::pair<std::string, std::string>> taken;  // files, and what they are
  for (const std::string& input : inputs) taken.emplace_back(input, "the input " + input);
  for (const auto& [option, file] : asked) {
    for (const auto& [other, what] : taken) {
      if (file.empty() || other.empty() || !are_same(file, other)) continue;
      throw InputError(fmt::format("{} {}: must be another file than {}", option, file, what));
    }
    taken.emplace_back(file, fmt::format("that of {}", option));
  }
}

void write_files(const std::vector<std::pair<std::string, std::string>>& files) {
  std::deque<TextDraft> drafts;
  for (const auto& [file, text] : files) {
    if (!file.empty() && !text.empty()) drafts.emplace_back(file, text);
  }
  for (TextDraft& draft : drafts) draft.commit();
}

}  // namespace ricochet::cli
