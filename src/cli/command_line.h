#pragma once

#include <CLI/CLI.hpp>
#include <deque>
#include <functional>
#include <string>

#include "src/report/json.h"
#include "src/studies/study.h"

namespace ricochet::cli {

/// What every study is asked.
struct StudyOptions {
  bool quick;
  std::string out;
};

/// A program of commands, of which one is carried out. Made for ricochet and for ricochet-studies.
class CommandLine {
 public:
  CommandLine();

  /// Returns the exit code: 0, 1 for a failure, 2 for bad input. Explains both in one line on
  /// stderr. What was printed has then reached standard output, or that is a failure.
  int run(int argc, char** argv);

 protected:
  /// A command. `examples`: a line each, for its help.
  CLI::App* add(const std::string& command, const std::string& summary,
                const std::string& examples = "");

  /// What is done if the command is the one called: returns the exit code.
  void on_call(CLI::App* command, const std::function<int()>& work);

  void add_format(CLI::App* command, bool& json);

  /// The options of a study, with its report in the folder of that name by default.
  StudyOptions& add_study_options(CLI::App* command, const studies::Study& study);

  /// A command that carries out the study that `make` makes when it is called. Further options may
  /// be added.
  CLI::App* add_study(const std::string& command, const std::string& summary,
                      const std::function<studies::Study()>& make,
                      const std::string& examples = "");

  /// All commands that the help shows, with their options: what manual and completion are made of.
  report::Json description() const;

 private:
  int carry_out(int argc, char** argv);
  int fail(int exit_code, const std::string& reason) const;
  int finish_output(int exit_code) const;
  std::string explanation(const CLI::ParseError& error) const;

  CLI::App app_;
  std::deque<StudyOptions> studies_;  // stay where they are
  std::function<int()> work_;
  std::string color_ = "auto";
};

}  // namespace ricochet::cli
