#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <deque>
#include <exception>
#include <functional>
#include <string>

#include "src/core/error.h"
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
  CommandLine() {
    app_.require_subcommand(1);
    app_.set_version_flag("--version", "ricochet " RICOCHET_VERSION);
  }

  /// Returns the exit code: 0, 1 for a failure, 2 for bad input. Explains both on stderr.
  int run(int argc, char** argv) {
    try {
      app_.parse(argc, argv);
      return work_();
    } catch (const CLI::ParseError& error) {
      if (error.get_exit_code() == 0) return app_.exit(error);  // --help, --version
      std::fprintf(stderr, "ricochet: %s; see ricochet --help\n", explanation(error).c_str());
      return bad_input;
    } catch (const InputError& error) {
      std::fprintf(stderr, "ricochet: %s\n", error.what());
      return bad_input;
    } catch (const std::exception& error) {
      std::fprintf(stderr, "ricochet: failed: %s\n", error.what());
      return 1;
    }
  }

 protected:
  CLI::App* add(const std::string& command, const std::string& summary) {
    return app_.add_subcommand(command, summary);
  }

  /// What is done if the command is the one called: returns the exit code.
  void on_call(CLI::App* command, const std::function<int()>& work) {
    command->callback([this, work] { work_ = work; });
  }

  void add_format(CLI::App* command, bool& json) {
    command->add_option("--format", "What to print: text or json")
        ->check(CLI::IsMember({"text", "json"}))
        ->default_str("text")
        ->each([&json](const std::string& format) { json = format == "json"; });
  }

  /// The options of a study, with its report in the folder of that name by default.
  StudyOptions& add_study_options(CLI::App* command, const studies::Study& study) {
    StudyOptions& options = studies_.emplace_back(StudyOptions{false, "reports/" + study.name});
    if (!study.quick.empty()) command->add_flag("--quick", options.quick, study.quick);
    command->add_option("--out", options.out, "Folder for the report")->capture_default_str();
    return options;
  }

  /// A command that carries out the study that `make` makes when it is called. Further options may
  /// be added.
  CLI::App* add_study(const std::string& command, const std::string& summary,
                      const std::function<studies::Study()>& make) {
    CLI::App* added = add(command, summary);
    StudyOptions& options = add_study_options(added, make());
    on_call(added, [make, &options] {
      std::fputs(studies::run(make(), options.quick, options.out).epilogue.c_str(), stdout);
      return 0;
    });
    return added;
  }

 private:
  static constexpr int bad_input = 2;

  /// What CLI11 says, but where it only misses a command the one that was taken for it.
  std::string explanation(const CLI::ParseError& error) const {
    if (app_.get_subcommands().empty() && app_.remaining_size() > 0) {
      std::string known;
      for (const CLI::App* command : app_.get_subcommands(nullptr)) {
        known += (known.empty() ? "" : ", ") + command->get_name();
      }
      return app_.remaining().front() + " is no command; allowed: " + known;
    }
    return error.what();
  }

  CLI::App app_{"ricochet: the fastest quiet speed of a braiding machine, and solvers put to it"};
  std::deque<StudyOptions> studies_;  // stay where they are
  std::function<int()> work_;
};

}  // namespace ricochet::cli
