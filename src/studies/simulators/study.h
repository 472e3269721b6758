#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "src/report/results.h"
#include "src/report/site/study.h"

namespace ricochet::studies::simulators {

/// How exactly a simulator is asked to simulate.
enum class Level { loose, usual, tight };
inline constexpr std::array<Level, 3> all_levels = {Level::loose, Level::usual, Level::tight};
std::string name_of(Level level);

/// A simulator of impacts: a program that reads scenes and writes impacts, see docs/simulators.md.
struct Tool {
  std::string name;
  std::string title;
  std::string kind;                   ///< of method: "event location", "time stepping", ...
  std::vector<std::string> packages;  ///< of Debian
  std::string source;                 ///< the driver, a file
  std::string compile;                ///< by a shell; empty for a script
  std::vector<std::string> run;       ///< program and arguments; the level is added
  std::vector<std::string> version;   ///< a command that prints it
  std::array<std::string, all_levels.size()> levels;  ///< what each means, in words
  std::string sets;    ///< how it means restitution and friction, and what it cannot express
  std::string advice;  ///< what to set to do better
};

/// The tools of a file tools.toml, whose folder has their drivers. Throws InputError for a file
/// that cannot be read, an unknown or missing key, a wrong type, or a name twice.
std::vector<Tool> tools_in(const std::filesystem::path& file);

/// A tool of one's own, from NAME=COMMAND, whose words are split at spaces. Throws InputError for
/// another text or a name that cannot name a file.
Tool own_tool(const std::string& text);

/// A tool that can be started, or why it cannot.
struct FoundTool {
  Tool tool;
  std::vector<std::string> command;  ///< program and arguments, without the level
  std::string version;               ///< as it prints it, one line
  std::string reason;                ///< empty: it can be started
};

/// Compiles the tool's driver, if it has one to compile, and asks for its version. Compiled drivers
/// are kept in `folder`, under a name with a hash of what they are made of. Installs nothing.
FoundTool found_tool(const Tool& tool, const std::filesystem::path& folder);

/// Installs the packages of the tools that are missing by apt-get, as root or through sudo. Says
/// what it does. Throws std::runtime_error if it fails.
void install(const std::vector<Tool>& tools);

struct Plan {
  int seed = 1;
  int scenes = 220;      ///< five of each kind and difficulty
  int tool_scenes = 44;  ///< the first of them, which tools answer, too: one of each
  std::vector<Level> levels = {all_levels.begin(), all_levels.end()};
  std::vector<Tool> tools = {};       ///< beside ricochet's own levels and methods
  bool needs_all = false;             ///< a tool that cannot be started is an error
  std::filesystem::path folder = {};  ///< keeps scenes, answers, drivers and logs
};

/// What is lost: draws the scenes, asks every simulator, scores the answers, and shrinks scenes
/// that break somebody. Scenes and answers are kept in the folder, see kept_answers. The value
/// "lost" is what ricochet itself loses, per 1,000 impacts. Throws InputError for a tool that
/// cannot be started if the plan needs all.
void add_losses(report::Results& results, const Plan& plan);

}  // namespace ricochet::studies::simulators

namespace ricochet::studies {

/// Contact laws, the speed and accuracy of simulators, what they lose, and the model that a scene
/// needs. Times are measured, so nothing that is timed runs in parallel. Throws InputError for a
/// number of scenes outside 1..1,000,000. `--quick` takes quick_scenes scenes and coarser grids.
Study simulators_study(const simulators::Plan& plan);

namespace simulators {
inline constexpr int quick_scenes = 44;
}

}  // namespace ricochet::studies
