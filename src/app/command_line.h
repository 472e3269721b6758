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
void print_table(const Table& table, bool json);

inline const char* name_of(carrier_track::Wall wall) {
  return wall == carrier_track::Wall::upper ? "upper" : "lower";
}

/// A row for each impact.
Table impact_table(std::span<const carrier_track::Impact> impacts);

/// Number of runs made at once.
int cores();

/// Each adds a command, whose help says what it does, with its options; in the file of its name,
/// but run in campaign.cpp, submit in archive.cpp, site and export in report.cpp, scene in
/// scene_choice.cpp, replay, merge and digest in verified_runs.cpp, and sample in agreement.cpp,
/// problem in problem_choice.cpp.
void add_machine(CommandLine& line);
void add_simulate(CommandLine& line);
void add_threshold(CommandLine& line);
void add_regimes(CommandLine& line);
void add_identify(CommandLine& line);
void add_scene(CommandLine& line);
void add_problem(CommandLine& line);
void add_list(CommandLine& line);
void add_solve(CommandLine& line);
void add_evaluate(CommandLine& line);
void add_ask(CommandLine& line);
void add_tell(CommandLine& line);
void add_compare(CommandLine& line);
void add_choose(CommandLine& line);
void add_plan(CommandLine& line);
void add_run(CommandLine& line);
void add_replay(CommandLine& line);
void add_merge(CommandLine& line);
void add_digest(CommandLine& line);
void add_submit(CommandLine& line);
void add_export(CommandLine& line);
void add_report(CommandLine& line);
void add_site(CommandLine& line);
void add_describe(CommandLine& line);

/// Adds the part sample to the command plan.
void add_sample(CommandLine& line, CLI::App* plan);

/// The commands of ricochet-studies that are more than a study, in studies_main.cpp and checks.cpp.
void add_calibrate(CommandLine& line);
void add_verify(CommandLine& line);
void add_simulators(CommandLine& line);
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
