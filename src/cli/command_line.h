#pragma once

#include <CLI/CLI.hpp>
#include <deque>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "src/report/json.h"
#include "src/report/site/study.h"

namespace ricochet::cli {

/// The options of every study.
struct StudyOptions {
  bool quick;
  std::string out;
};

/// Adds the option --set, which changes keys of a machine file.
void add_settings(CLI::App* command, std::vector<std::string>& settings);

/// A program with commands, one of which is executed: the base of ricochet and of the programs that
/// it calls.
class CommandLine {
 public:
  CommandLine();

  /// Returns the exit code: 0, 1 for a failure, 2 for bad input. A failure and bad input are
  /// explained in one line on stderr. Standard output has been flushed, or that is a failure.
  int run(int argc, char** argv);

 protected:
  /// Starts a group of the help: the commands that are added from now on.
  void start_group(const std::string& title) { group_ = title; }

  /// Adds a command. `examples`: one line each, for its help.
  CLI::App* add(const std::string& command, const std::string& summary,
                const std::string& examples = "");

  /// Sets the function that runs if this command is called; it returns the exit code.
  void on_call(CLI::App* command, const std::function<int()>& work);

  void add_format(CLI::App* command, bool& json);

  /// Adds the options of a study; its report goes to the folder of its name by default.
  StudyOptions& add_study_options(CLI::App* command, const studies::Study& study);

  /// Adds a command that runs the study returned by `make` when it is called. Further options may
  /// be added.
  CLI::App* add_study(const std::string& command, const std::string& summary,
                      const std::function<studies::Study()>& make,
                      const std::string& examples = "");

  /// Adds a hidden command that prints description(), with which ricochet describes the commands of
  /// all programs.
  void add_description();

  /// Returns all commands in the help, with their options: the input of manual and completion.
  report::Json description() const;

 private:
  int carry_out(std::vector<std::string> arguments);
  bool names_no_command() const;
  int fail(int exit_code, const std::string& reason) const;
  int finish_output(int exit_code) const;
  std::pair<const CLI::App*, std::string> called() const;
  std::string explanation(const CLI::ParseError& error) const;

  CLI::App app_;
  std::string group_ = "Commands";
  std::deque<StudyOptions> studies_;  // addresses must remain valid
  std::function<int()> work_;
  std::string color_ = "auto";
};

}  // namespace ricochet::cli
