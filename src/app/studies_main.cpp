#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/error.h"
#include "ricochet/problem.h"
#include "ricochet/solver.h"
#include "src/app/command_line.h"
#include "src/app/other_program.h"
#include "src/app/scene_choice.h"
#include "src/core/files.h"
#include "src/core/names.h"
#include "src/studies/best_values/best_values.h"
#include "src/studies/calibration/study.h"
#include "src/studies/fireworks/study.h"
#include "src/studies/paper/loss.h"
#include "src/studies/suite/suite.h"
#include "src/studies/surrogate/study.h"

namespace ricochet::cli {

namespace {

/// Adds a command that runs the study returned by `make` when it is called.
void add_study(CommandLine& line, const std::string& command,
               const std::function<studies::Study()>& make, const std::string& examples) {
  CLI::App* added = line.add(command, summary_of(command), examples);
  const auto options = add_study_options(added, make());
  line.on_call(added, [make, options] {
    tell(studies::run(make(), options->quick, options->out));
    return 0;
  });
}

}  // namespace

}  // namespace ricochet::cli

/// The studies of the suite itself, which ricochet calls.
int main(int argc, char** argv) {
  using namespace ricochet;
  using namespace ricochet::cli;
  CommandLine line;
  add_calibrate(line);
  add_study(line, "surrogate", studies::surrogate_study, "  ricochet surrogate --quick");
  add_study(line, "fireworks", studies::fireworks_study, "  ricochet fireworks --quick");
  add_verify(line);
  add_simulators(line);
  add_best_values(line);
  line.add_description();
  return line.run(argc, argv);
}

namespace ricochet::cli {

void add_calibrate(CommandLine& line) {
  CLI::App* command = line.add("calibrate", summary_of("calibrate"),
                               "  ricochet calibrate --quick\n"
                               "  ricochet calibrate --all-interpretations --converge");
  const auto options = std::make_shared<studies::CalibrationOptions>();
  command->add_option("--interpretation", options->interpretation,
                      "A name of `ricochet list interpretations`, in place of the default");
  command->add_flag("--all-interpretations", options->all_interpretations,
                    "Compare all interpretations");
  command->add_flag(
      "--converge", options->converge,
      "Search the best interpretations longer, with three seeds and two solvers, until they "
      "agree");
  add_value(command, "--seed", options->seed, "Seed of the searches");
  add_value(command, "--solver", options->solver, "Solver that searches within the bounds");
  const auto study = add_study_options(command, studies::calibration_study(*options, {}));
  line.on_call(command, [options, study] {
    options->folder = study->out;
    tell(
        studies::run(studies::calibration_study(*options, provenance()), study->quick, study->out));
    return 0;
  });
}

namespace {

struct BestValuesOptions {
  std::string problems;           ///< a pattern, or a part of the names; empty: all
  std::optional<double> seconds;  ///< start no search after this time
  std::int64_t budget = 50'000;   ///< of each search, evaluations a variable
  std::string out = "reports/best-values/best_known.toml";
  std::string from;           ///< if not empty: take values from the runs of this store instead
  std::string hard_machines;  ///< if not empty: search for hard machines, and write them here
  bool prove = false;         ///< say which are proven instead
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
  std::vector<Family> families = carrier_track::case_families();
  families.push_back(carrier_track::calibration_family());
  const std::vector<Problem> problems = every_problem(families);
  if (options.prove) {
    fmt::print("{}", terminal_text_of(proofs(matching(problems, options.problems))));
    return 0;
  }
  studies::best_values::Plan plan;
  plan.problems = options.problems;
  if (options.seconds) plan.seconds = *options.seconds;
  plan.effort.evaluations_per_variable = options.budget;
  const std::filesystem::path file = options.out;
  const FolderLock alone(file.has_parent_path() ? file.parent_path() : ".");
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
  add_value(command, "--problems", options->problems,
            "A pattern such as robust-*-C4, or a part of the names", "PROBLEMS");
  command->add_option("--seconds", options->seconds,
                      "Start no search after this time [s]; the same command continues");
  add_value(command, "--budget", options->budget,
            "Evaluations a variable of each search: 50 times those of a comparison")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000'000}));
  add_value(command, "--out", options->out, "The file of the values", "FILE");
  add_value(command, "--from", options->from,
            "Instead: take the values of a store's runs that are better than those known", "STORE")
      ->excludes("--problems", "--seconds", "--budget");
  add_value(command, "--hard-machines", options->hard_machines,
            "Instead: search machines whose top speed in the window is hard to find, and write "
            "this file",
            "FILE")
      ->excludes("--problems", "--seconds", "--budget", "--from", "--out");
  command
      ->add_flag("--prove", options->prove,
                 "Instead: say of every problem of one variable whether a complete scan leaves a "
                 "better point")
      ->excludes("--seconds", "--budget", "--from", "--out", "--hard-machines");
  line.on_call(command, [options] { return best_values(*options); });
}

}  // namespace ricochet::cli
