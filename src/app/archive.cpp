#include "src/experiment/archive.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "ricochet/error.h"
#include "ricochet/solver.h"
#include "src/app/campaign.h"
#include "src/app/command_line.h"
#include "src/app/other_program.h"
#include "src/core/files.h"
#include "src/core/names.h"
#include "src/core/progress.h"
#include "src/experiment/archived_campaign.h"
#include "src/report/text.h"

namespace ricochet::cli {

namespace {

namespace fs = std::filesystem;

struct SubmitOptions {
  std::string store;
  std::string out;
  std::string solvers;   ///< patterns; empty: the user's solvers of the store
  std::string citation;  ///< a file; empty: none
  Verification verification;
};

/// The user's solvers of a store.
std::vector<std::string> own_solvers_of(const CampaignDescription& description) {
  const std::vector<Solver> known = all_solvers();
  std::vector<std::string> own;
  for (const StoredSolver& solver : description.solvers) {
    const bool of_suite = std::ranges::find(known, solver.name, &Solver::name) != known.end();
    if (!of_suite) own.push_back(solver.name);
  }
  return own;
}

std::string text_in(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(fmt::format("{}: cannot be read", file));
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The programs that the wanted solvers of a store are.
std::vector<std::string> wanted_programs(const CampaignDescription& description,
                                         const std::vector<std::string>& patterns) {
  std::vector<std::string> programs;
  for (const std::string& name : own_solvers_of(description)) {
    const auto program = description.made.find(StoredCampaign::program_key(name));
    if (fits_any(name, patterns) && program != description.made.end()) {
      programs.push_back(program->second);
    }
  }
  return programs;
}

int submit(const SubmitOptions& options) {
  const std::string file = archive_named(options.store);
  const Store store = Store::open(file, Store::For::reading);
  warn_of_missing_runs(file);
  told_completeness(store, file);
  std::vector<std::string> patterns = split_patterns(options.solvers);
  if (patterns.empty()) patterns = own_solvers_of(store.description());
  if (patterns.empty()) {
    throw InputError(fmt::format(
        "{}: has only solvers of the suite: --solvers PATTERNS chooses among them", options.store));
  }
  std::vector<std::string> names;
  for (const StoredSolver& solver : store.description().solvers) names.push_back(solver.name);
  require_fit(patterns, names, "--solvers");
  const auto wanted = [&](const RunKey& key) { return fits_any(key.cell.solver, patterns); };
  const auto keys = store.keys();
  const auto runs = std::ranges::count_if(keys, wanted);
  if (runs == 0) throw InputError(fmt::format("{}: has no such run", options.store));
  const bool allowed = options.verification.allow_programs;
  if (!allowed)
    announce_programs(wanted_programs(store.description(), patterns), false, options.store);
  const std::string note = verified({file}, wanted, options.verification);
  std::map<std::string, std::string> notes = {
      {"command", fmt::format("ricochet submit --solvers '{}'", fmt::join(patterns, ","))},
      {"verified", note}};
  if (!options.citation.empty()) notes["citation"] = text_in(options.citation);
  write_archive(store, options.out, wanted, notes);
  fmt::print("{} of {}: {}, {:.2f} MB\nverified: {}\n", report::counted(runs, "run"),
             fmt::join(patterns, ", "), options.out,
             static_cast<double>(fs::file_size(options.out)) / 1e6, note);
  return 0;
}

}  // namespace

std::string archive_named(const std::string& name) {
  if (fs::is_directory(name) && fs::exists(fs::path(name) / "runs.sqlite")) {
    return (fs::path(name) / "runs.sqlite").string();  // as `run --out` has it
  }
  if (name != "archive") return name;
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path();
  constexpr std::array places = {"../share/ricochet/reference.archive",
                                 "../../../../reports/archive/reference.archive"};
  for (const char* place : places) {
    const fs::path file = (program / place).lexically_normal();
    if (fs::exists(file)) return file.string();
  }
  throw InputError(fmt::format("archive: {} is not there",
                               (program / places.front()).lexically_normal().string()));
}

Plan plan_against_archive(const std::string& archive, const std::vector<std::string>& own_solvers,
                          const std::vector<std::string>& problems, const Catalogue& catalogue,
                          const std::string& out) {
  const Store store = Store::open(archive, Store::For::reading);
  const CampaignDescription& description = store.description();
  const ChangedSolvers changes = changed_solvers(description, catalogue);
  if (!changes.missing.empty()) {
    warn(fmt::format("this build lacks solvers of {}, whose runs are left out: {}", archive,
                     fmt::join(changes.missing, ", ")));
  }
  if (!changes.changed.empty()) {
    warn(fmt::format("{} has runs of other versions: {}", archive,
                     fmt::join(changes.changed, ", ")));
  }
  Plan plan = plan_against(description, own_solvers, catalogue, problems);
  const fs::path file = fs::path(out) / "runs.sqlite";
  if (fs::exists(file)) return plan;
  const Campaign campaign = campaign_of(description, plan, catalogue);
  const MadeFolder folder(out);
  start_against(store, archive, campaign, provenance(), file);
  return plan;
}

void add_submit(CommandLine& line) {
  CLI::App* command =
      line.add("submit", "Pack runs of a store, checked and compressed, as an archive",
               "  ricochet submit mine/runs.sqlite --out mine.archive --citation CITATION.cff\n"
               "  ricochet merge all.sqlite reports/archive/reference.archive mine.archive");
  const auto options = std::make_shared<SubmitOptions>();
  add_value(command, "store", options->store, "A store, runs.sqlite", "FILE")->required();
  add_value(command, "--out", options->out, "The archive", "FILE")->required();
  add_value(command, "--solvers", options->solvers,
            "Patterns, separated by commas; default: the solvers that are not of the suite",
            "SOLVERS");
  add_value(command, "--citation", options->citation, "How to cite the solver: a CITATION.cff",
            "FILE");
  add_verification(command, options->verification);
  line.on_call(command, [options] { return submit(*options); });
}

}  // namespace ricochet::cli
