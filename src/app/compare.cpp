#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "ricochet/error.h"
#include "src/analysis/comparison/reported_part.h"
#include "src/analysis/comparison/study.h"
#include "src/app/campaign.h"
#include "src/app/command_line.h"
#include "src/app/own_comparison.h"
#include "src/app/scene_choice.h"
#include "src/core/names.h"
#include "src/studies/suite/suite.h"

namespace ricochet::cli {
namespace {

struct CompareOptions {
  studies::ComparisonOptions compared;
  std::string family;               ///< whose problems are compared; empty: those of `compared`
  SceneChoice machine;              ///< whose problems are compared; empty: the suite's
  std::string against;              ///< an archive; empty: none
  std::vector<std::string> stores;  ///< two, or none
  bool json = false;                ///< of the stores, or of problem files
  OwnComparisonOptions own;         ///< of problem files
};

/// Carries a comparison out, or goes on with it, and writes its report.
int carry_out(const Plan& plan, const Catalogue& catalogue, bool quick, const std::string& out,
              std::chrono::steady_clock::time_point start) {
  RunOptions here;
  here.out = out;
  here.resume = true;
  const auto [campaign, store] = carried_out(plan, catalogue, {}, here, "the same command");
  tell(studies::run(studies::comparison_study(campaign, store), quick, out, start));
  return 0;
}

/// The patterns of --problems, or of --family; empty if neither is given.
std::string problem_patterns(const CompareOptions& options, const Catalogue& catalogue) {
  if (options.family.empty()) return options.compared.problems;
  const auto name_of = [](const Family& family) { return family.name; };
  return named(catalogue.families, options.family, "family", name_of).name + "-*";
}

int compare_problems(const CompareOptions& options, const StudyOptions& study) {
  studies::ComparisonOptions compared = options.compared;
  const SceneChoice& machine = options.machine;
  if (!machine.scene_file.empty()) {
    compared.scene = carrier_track::write_scene(choose_scene(machine).scene);
  } else if (!machine.settings.empty()) {
    throw InputError("--set " + machine.settings.front() +
                     ": changes a machine file: give --scene FILE");
  }
  const auto start = std::chrono::steady_clock::now();
  const Catalogue catalogue = studies::whole_catalogue();
  compared.problems = problem_patterns(options, catalogue);
  const Plan plan = studies::comparison_plan(compared, study.quick, catalogue);
  return carry_out(plan, catalogue, study.quick, study.out, start);
}

/// Compares the user's solvers with those whose runs an archive has.
int compare_against(const CompareOptions& options, const std::string& out) {
  const auto start = std::chrono::steady_clock::now();
  const std::vector<std::string>& own_solvers = options.compared.added_solvers;
  if (own_solvers.empty()) throw InputError("--against: needs --solver, your own solver");
  const Catalogue catalogue = studies::whole_catalogue();
  const std::string patterns = problem_patterns(options, catalogue);
  const Plan plan = plan_against_archive(
      archive_named(options.against), own_solvers,
      patterns.empty() ? std::vector<std::string>() : split_patterns(patterns), catalogue, out);
  return carry_out(plan, catalogue, false, out, start);
}

/// Whether --problems has problem files. Throws InputError where options do not fit together.
bool asks_own_problems(const CLI::App& command, const std::string& list) {
  const std::vector<std::string> problems = split_patterns(list);
  const auto files = std::count_if(problems.begin(), problems.end(), own::is_problem_file);
  const bool own = files > 0;
  if (own && files < std::ssize(problems)) {
    throw InputError(
        fmt::format("--problems {}: some are problem files: compare the others apart", list));
  }
  const std::vector<std::string> of_others =
      own ? std::vector<std::string>{"--quick",     "--scene",   "--set",   "--smoothings",
                                     "--instances", "--against", "--stores"}
          : std::vector<std::string>{"--starts", "--evaluations", "--seconds", "--workers",
                                     "--allow-programs"};
  for (const std::string& option : of_others) {
    if (command.get_option(option)->count() == 0) continue;
    throw InputError(option +
                     (own ? ": is not for problem files" : ": needs problem files in --problems"));
  }
  if (!own &&
      command.get_option("--format")->count() + command.get_option("--stores")->count() == 1) {
    throw InputError("--format: needs --stores, or problem files in --problems");
  }
  return own;
}

int compare(const CompareOptions& options, const StudyOptions& study, const CLI::App& command) {
  if (asks_own_problems(command, options.compared.problems)) {
    OwnComparisonOptions own = options.own;
    own.compared = options.compared;
    own.json = options.json;
    if (command.get_option("--out")->count() > 0) own.out = study.out;
    // What is kept survives, and the program has a limit of its own.
    if (command.get_option("--run-seconds")->count() == 0) own.compared.limits.seconds = 1e8;
    return compare_on_files(own);
  }
  const std::vector<std::string>& stores = options.stores;
  if (!stores.empty()) return compare_stores(stores[0], stores[1], options.json);
  if (!options.against.empty()) {
    return compare_against(options, study.out);
  }
  return compare_problems(options, study);
}

void add_own_options(CLI::App* command, OwnComparisonOptions& own) {
  add_allowance(command, own.allow_programs);
  add_value(command, "--starts", own.starts, "Of problem files: starts, the same for all solvers");
  command
      ->add_option("--evaluations", own.evaluations,
                   "Of problem files: evaluations of all runs together, shared out evenly")
      ->excludes("--budget");
  command
      ->add_option("--seconds", own.seconds,
                   "Of problem files: time for all runs together [s], as evaluations that fit")
      ->excludes("--budget", "--evaluations");
  add_value(command, "--workers", own.workers,
            "Of problem files: runs at once; 0: as many as cores");
}

}  // namespace

void add_compare(CommandLine& line) {
  CLI::App* command = line.add(
      "compare", "Compare solvers: success rates, costs and ranks, as a report",
      "  ricochet compare --quick\n"
      "  ricochet compare --problems 'hs-*' --solvers 'nlopt-*' --budget 100,1000\n"
      "  ricochet compare --family pathological --solvers 'nlopt-*'\n"
      "  ricochet compare --scene machine.toml --problems 'top-speed-*' --quick\n"
      "  ricochet compare --solver ./mine.so --solver 'python3 mine.py' --solvers 'nlopt-*'\n"
      "  ricochet compare --solver ./mine.so --against archive --problems 'hs-*,least-squares-*'\n"
      "  ricochet compare --problems mine.toml --allow-programs --evaluations 20000\n"
      "  ricochet compare --stores archive mine/runs.sqlite");
  const auto options = std::make_shared<CompareOptions>();
  const auto study =
      add_study_options(command, {"comparison", "Fewer instances and evaluations", nullptr});
  add_scene_file(command, options->machine.scene_file, options->machine.settings);
  CLI::Option* against =
      add_value(command, "--against", options->against,
                "Run only the solvers of --solver, on the problems and beside the runs of "
                "this archive; archive: that of the reference, which is included",
                "ARCHIVE");
  add_value(command, "--stores", options->stores,
            "Print how far two stores, or archives, order their entries alike, and which "
            "entries changed",
            "FILE")
      ->expected(2);
  add_format(command, options->json);
  add_value(command, "--problems", options->compared.problems,
            "Patterns, separated by commas; default: 48 problems of 1 to 32 variables; with "
            "--against those of the archive. Or problem files (TOML) of your own",
            "PROBLEMS");
  command->add_option("--family", options->family, "Problems of this family")
      ->type_name("FAMILY")
      ->excludes("--scene", "--problems");
  add_value(command, "--solvers", options->compared.solvers, "Patterns, separated by commas",
            "SOLVERS");
  add_value(command, "--solver", options->compared.added_solvers,
            "A further solver: a shared library or a program; may be repeated", "SOLVER")
      ->allow_extra_args(false);
  add_value(command, "--formulations", options->compared.formulations,
            "Patterns, such as *count or penalised*");
  command
      ->add_option("--smoothings", options->compared.smoothings,
                   "Further smoothing parameters of the surrogate")
      ->delimiter(',');
  command
      ->add_option("--budget", options->compared.budgets,
                   "Evaluations for each variable; of a problem file 100")
      ->delimiter(',');
  add_value(command, "--instances", options->compared.instances, "Instances of every problem");
  add_limits(command, options->compared.limits);
  add_own_options(command, options->own);
  for (const char* option : {"--scene", "--set", "--solvers", "--formulations", "--smoothings",
                             "--budget", "--instances", "--quick", "--stores"}) {
    against->excludes(command->get_option(option));
  }
  line.on_call(command, [options, study, command] { return compare(*options, *study, *command); });
}

}  // namespace ricochet::cli
