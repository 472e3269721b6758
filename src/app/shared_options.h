#pragma once

#include <memory>
#include <string>
#include <vector>

#include "src/app/command_line.h"
#include "src/experiment/worker.h"
#include "src/report/site/study.h"

namespace ricochet::cli {

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
