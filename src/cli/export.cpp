#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "ricochet/error.h"
#include "src/benchmark/comparison/rated_families.h"
#include "src/benchmark/experiment/store/store.h"
#include "src/benchmark/export/formats.h"
#include "src/benchmark/export/output_folder.h"
#include "src/cli/archive.h"
#include "src/cli/commands.h"
#include "src/cli/finished_campaign.h"
#include "src/cli/named.h"
#include "src/cli/stored_runs.h"
#include "src/core/one_line.h"
#include "src/core/warning.h"

namespace ricochet::cli {
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
  command->add_option("store", options->store, "A store, runs.sqlite")
      ->type_name("FILE")
      ->required();
  command->add_option("--format", options->format, "One of these formats")
      ->type_name(fmt::format("FORMAT:{{{}}}", fmt::join(names, ",")))
      ->required();
  command->add_option("--out", options->out, "Folder, new or empty")
      ->type_name("FOLDER")
      ->required();
  line.on_call(command, [options] { return export_store(*options); });
}

}  // namespace ricochet::cli
