#include "src/research/best_values/best_values.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "problems/carrier_track/problems/families.h"
#include "ricochet/error.h"
#include "ricochet/families.h"
#include "src/cli/commands.h"
#include "src/cli/other_program.h"
#include "src/core/folder_lock.h"
#include "src/core/one_line.h"
#include "src/core/text_file.h"
#include "src/research/best_values/hard_search.h"
#include "src/research/best_values/stored_values.h"
#include "src/research/paper/calibration_problem.h"

namespace ricochet::cli {
namespace {

struct BestValuesOptions {
  std::string problems;           ///< a pattern, or a part of the names; empty: all
  std::optional<double> seconds;  ///< start no search after this time
  std::int64_t budget = 50'000;   ///< of each search, evaluations a variable
  std::string out = "reports/best-values/best_known.toml";
  std::string from;           ///< if not empty: take values from the runs of this store instead
  std::string hard_machines;  ///< if not empty: search for hard machines, and write them here
};

/// The whole path of a file, as a terminal may show it.
std::string shown(const std::filesystem::path& file) {
  return one_line(std::filesystem::absolute(file).lexically_normal().string());
}

/// Finds the twenty hardest of 500 machines around each case.
int look_for_hard_machines(const std::string& file) {
  const auto found = studies::best_values::find_hard_machines(500, 20);
  write_text_file(file, carrier_track::write_hard_machines(found));
  fmt::print("{} hard machines; the file: {}\n", found.machines.size(), shown(file));
  return 0;
}

int best_values(const BestValuesOptions& options) {
  using namespace studies::best_values;
  if (!options.hard_machines.empty()) return look_for_hard_machines(options.hard_machines);
  if (options.seconds && !(*options.seconds >= 0)) {
    throw InputError(fmt::format("--seconds {}: must be >= 0", *options.seconds));
  }
  Plan plan;
  plan.problems = options.problems;
  if (options.seconds) plan.seconds = *options.seconds;
  plan.effort.evaluations_per_variable = options.budget;
  const std::filesystem::path file = options.out;
  const FolderLock alone(file.has_parent_path() ? file.parent_path() : ".");
  std::vector<Family> families = carrier_track::case_families();
  families.push_back(carrier_track::calibration_family());
  const std::vector<Problem> problems = every_problem(families);
  if (!options.from.empty()) {
    const std::size_t improved = take_stored_values(problems, options.from, file);
    fmt::print("{} best values better than before{}\n", improved,
               improved == 0 ? "" : "; the file: " + shown(file));
    return 0;
  }
  const Outcome outcome = find_best_values(problems, plan, file);
  fmt::print(
      "{} of {} best values looked for; {} better than before or new; {} without a feasible "
      "point\n",
      outcome.finished, outcome.wanted, outcome.improved, outcome.infeasible);
  if (outcome.finished < outcome.wanted) {
    fmt::print("Not all are finished: the same command goes on.\n");
  } else {
    fmt::print("The file: {}\n", shown(file));
  }
  return 0;
}

}  // namespace

void add_best_values(CommandLine& line) {
  CLI::App* command =
      line.add("best-values", summary_of("best-values"),
               "  ricochet best-values --problems 'robust-*-C4'\n"
               "  ricochet best-values --seconds 600  # and the same again, to go on");
  const auto options = std::make_shared<BestValuesOptions>();
  command
      ->add_option("--problems", options->problems,
                   "A pattern such as robust-*-C4, or a part of the names")
      ->type_name("PROBLEMS");
  command->add_option("--seconds", options->seconds,
                      "Start no search after this time [s]; the same command continues");
  command
      ->add_option("--budget", options->budget,
                   "Evaluations a variable of each search: 50 times those of a comparison")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000'000}))
      ->capture_default_str();
  command->add_option("--out", options->out, "The file of the values")
      ->type_name("FILE")
      ->capture_default_str();
  command
      ->add_option("--from", options->from,
                   "Instead: take the values of a store's runs that are better than those known")
      ->type_name("STORE")
      ->excludes("--problems", "--seconds", "--budget");
  command
      ->add_option("--hard-machines", options->hard_machines,
                   "Instead: search machines whose fastest quiet speed is hard to find, and write "
                   "this file")
      ->type_name("FILE")
      ->excludes("--problems", "--seconds", "--budget", "--from", "--out");
  line.on_call(command, [options] { return best_values(*options); });
}

}  // namespace ricochet::cli
