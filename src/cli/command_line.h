#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "src/report/json.h"

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

}  // namespace ricochet::cli
