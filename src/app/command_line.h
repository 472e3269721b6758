#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "ricochet/error.h"
#include "ricochet/machine.h"
#include "src/core/names.h"
#include "src/experiment/worker.h"
#include "src/report/drawing.h"
#include "src/report/json.h"
#include "src/report/site/study.h"
#include "src/report/table.h"

namespace ricochet::cli {

/// A program with commands, one of which is executed. The function of a command holds the command's
/// options, by a std::shared_ptr.
class CommandLine {
 public:
  CommandLine();

  /// Returns the exit code: 0, 1 for a failure, 2 for bad input. A failure and bad input are
  /// explained in one line on stderr. Standard output has been flushed, or that is a failure.
  int run(int argc, char** argv);

  /// Starts a group of the help: the commands that are added from now on.
  void start_group(const std::string& title) { group_ = title; }

  /// Adds a command. `examples`: one line each, for its help.
  CLI::App* add(const std::string& command, const std::string& summary,
                const std::string& examples = "");

  /// Adds a part of a command, such as the new of `machine new`.
  CLI::App* add_part(CLI::App* command, const std::string& part, const std::string& summary);

  /// Sets the function that runs if this command is called; it returns the exit code.
  void on_call(CLI::App* command, const std::function<int()>& work);

  /// Adds a hidden command that prints description(), with which ricochet describes the commands of
  /// all programs.
  void add_description();

  /// Returns all commands in the help, with their options: the input of manual and completion.
  report::Json description() const;

 private:
  void add_usual_options(CLI::App* command);
  int carry_out(std::vector<std::string> arguments);
  bool names_no_command() const;
  int fail(int exit_code, const std::string& reason) const;
  int finish_output(int exit_code) const;
  std::pair<const CLI::App*, std::string> called() const;
  std::string explanation(const CLI::ParseError& error) const;

  CLI::App app_;
  std::string group_ = "Commands";
  std::function<int()> work_;
  std::string color_ = "auto";
  std::string first_;  ///< argument
};

/// Returns the element of that name, in any letter case if only one fits. Throws InputError, which
/// says `what` it should be, if there is none; `listing` is the command that lists the names, if
/// they are too many to print.
template <class List, class NameOf>
auto named(const List& list, const std::string& wanted, const std::string& what, NameOf name_of,
           const std::string& listing = "") {
  std::vector<std::string> known;
  for (const auto& entry : list) known.push_back(name_of(entry));
  const std::string* name = match(wanted, known);
  for (const auto& entry : list) {
    if (name != nullptr && name_of(entry) == *name) return entry;
  }
  throw InputError(fmt::format(
      "{}: there is no such {}; {}", wanted, what,
      listing.empty() ? what_instead(wanted, known) : what_instead(wanted, known, listing)));
}

/// Prints a study's closing lines. Throws, and the command fails, if a chart of its report could
/// not be drawn.
inline void tell(const studies::Finished& finished) {
  std::fputs(finished.epilogue.c_str(), stdout);
  report::require_none(finished.failures);
}

/// Adds an option; the help shows its default, and `kind`, what its value is, such as "FILE".
template <class T>
CLI::Option* add_value(CLI::App* command, const std::string& name, T& value,
                       const std::string& help, const std::string& kind = "") {
  CLI::Option* option = command->add_option(name, value, help);
  if (!kind.empty()) option->type_name(kind);
  if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
    option->capture_default_str();
  }
  return option;
}

/// Prints a table: as JSON, a list of objects, or for people, cut at the edge of a terminal.
void print(const Table& table, bool json);

inline const char* name_of(carrier_track::Wall wall) {
  return wall == carrier_track::Wall::upper ? "upper" : "lower";
}

/// A row for each impact.
Table impact_table(std::span<const carrier_track::Impact> impacts);

/// Number of runs made at once.
int cores();

/// The commands, each with its options in the file of its name; run in campaign.cpp, submit in
/// archive.cpp, and replay, merge and digest in verified_runs.cpp.
///
/// Prints a machine file to start from, checks one, or writes the page of advice into a folder.
void add_machine(CommandLine& line);

/// Prints impacts, peaks, count and certainty of one run.
void add_simulate(CommandLine& line);

/// Prints the fastest quiet speed of a machine, from its regimes in the long run or by a limit of
/// its window. For the paper's cases it prints the threshold by the paper's rule, too.
void add_threshold(CommandLine& line);

/// Prints what the carrier of a machine does in the long run, from border to border; or the borders
/// over a constant; or the motions that sampled starts lead to.
void add_regimes(CommandLine& line);

/// Fits a machine to recorded knocks and prints its constants and safe speed with their intervals.
void add_identify(CommandLine& line);

/// Prints a scene as a machine file; of a case of the paper, it says which numbers are fitted.
void add_scene(CommandLine& line);

/// Lists cases, problems, solvers or interpretations.
void add_list(CommandLine& line);

/// Runs one solver once and prints its progress and its score.
void add_solve(CommandLine& line);

/// Evaluates a problem for an external optimiser: reads a line of JSON with a point, or with a list
/// of points, on standard input and writes a line of JSON with the values on standard output. Exit
/// code 1 if a line was invalid, or if a point evaluated twice had two results.
void add_evaluate(CommandLine& line);

/// Compares solvers on problems as a separate campaign, which resumes automatically if it was
/// interrupted; or the user's solvers with those whose runs an archive has; or two stores.
void add_compare(CommandLine& line);

/// Prints a plan to start from, what a plan would run and for how long, or a script for the
/// workload manager Slurm that runs a plan as a number of jobs and merges their stores.
void add_plan(CommandLine& line);

/// Adds to the command plan its part sample: prints a sample of the problems of an archive, evenly
/// over their difficulty, and how far the order of the entries on it agrees with that on all.
void add_sample(CommandLine& line, CLI::App* plan);

/// Runs or resumes a plan; it is one of the ranks if mpirun started several. After all runs it
/// writes the report.
void add_run(CommandLine& line);

/// Repeats a stored run and says whether the results are identical to the bit: exit code 0, or 1.
/// Starts only the run's own solver, and that only if it is of the suite or programs are allowed.
void add_replay(CommandLine& line);

/// Joins the stores of a campaign's parts into a new one.
void add_merge(CommandLine& line);

/// Prints the digest of a store.
void add_digest(CommandLine& line);

/// Writes runs of a store as an archive, after some of them have been repeated to the bit.
void add_submit(CommandLine& line);

/// Exports a campaign's store to the formats of other tools.
void add_export(CommandLine& line);

/// Draws a report, or all reports of a folder, again from their data. Throws InputError, which
/// names file and place, for data that are none of a report's or of which a chart cannot be drawn;
/// then everything else has been drawn.
void add_report(CommandLine& line);

/// Writes the site of a folder of reports, ready for a static host, and prints its size. Throws
/// InputError as publish_site does, and for data of which something cannot be drawn; then
/// everything else has been drawn.
void add_site(CommandLine& line);

/// Hidden: prints what is installed beside the program, its manual and completions for the shells.
void add_describe(CommandLine& line);

/// The commands of ricochet-studies that are more than a study.
///
/// Fits the unknown parameters to the paper's claims, or the long run's borders to the thresholds.
void add_calibrate(CommandLine& line);

/// Runs the study, and prints its summary, or its results as JSON: exit code 1 where a count called
/// certain is wrong. Or prints one scene, to examine a disagreement.
void add_verify(CommandLine& line);

/// Runs the test, and prints its summary, or its results as JSON: exit code 1 where ricochet itself
/// misses or invents an impact. Or lists the tools, or installs them from Debian and from Python's
/// registry.
void add_impact_test(CommandLine& line);

/// Searches for the best value of every problem, resumes where it was stopped, and writes the
/// values to a file; or takes better values from a store; or searches for hard machines.
void add_best_values(CommandLine& line);

/// Returns the output of --version: version, commit, compiler, and the linked libraries.
std::string version();

/// The options of every study.
struct StudyOptions {
  bool quick;
  std::string out;
};

/// Adds the options of a study; its report goes to the folder of its name by default. The command's
/// function must keep what is returned.
std::shared_ptr<StudyOptions> add_study_options(CLI::App* command, const studies::Study& study);

void add_format(CLI::App* command, bool& json);

/// Adds the option --set, which changes keys of a machine file.
void add_settings(CLI::App* command, std::vector<std::string>& settings);

/// Adds --scene and --set: problems of the user's machine in place of the suite's.
void add_scene_file(CLI::App* command, std::string& file, std::vector<std::string>& settings);

/// Adds the limits of every run.
void add_limits(CLI::App* command, Limits& limits);

/// Adds --allow-programs, see announce_programs().
void add_allowance(CLI::App* command, bool& allowed);

}  // namespace ricochet::cli
