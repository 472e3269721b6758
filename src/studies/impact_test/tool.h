#pragma once

#include <array>
#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "solvers/outside/line_solver.h"
#include "src/studies/impact_test/smallest_scene.h"
#include "src/studies/impact_test/test_scene.h"

namespace ricochet::studies::impact_test {

/// How exactly a tool is asked to simulate.
enum class Level { loose, usual, tight };
inline constexpr std::array<Level, 3> all_levels = {Level::loose, Level::usual, Level::tight};
std::string name_of(Level level);

/// A simulator of impacts: a program that reads scenes and writes impacts, see docs/impact-test.md.
struct Tool {
  std::string name;
  std::string title;
  std::string kind;                   ///< of method: "event location", "time stepping", ...
  std::vector<std::string> packages;  ///< of Debian
  std::filesystem::path source;       ///< the driver
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

/// A tool that is there and can be started.
struct ToolProgram {
  Tool tool;
  std::vector<std::string> command;  ///< program and arguments, without the level
  std::string version;               ///< as it prints it, one line
};

/// A tool, or why it cannot be started.
struct FoundTool {
  std::optional<ToolProgram> program;
  std::string reason;
};

/// Compiles the tool's driver, if it has one to compile, and asks for its version. Compiled drivers
/// are kept in `folder`, under a name with a hash of what they are made of. Installs nothing.
FoundTool found_tool(const Tool& tool, const std::filesystem::path& folder);

/// Installs the packages of the tools that are missing by apt-get, as root or through sudo. Says
/// what it does. Throws std::runtime_error where it fails.
void install(const std::vector<Tool>& tools);

/// A tool that cannot be used at all. The message says why.
class ToolFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// How long a tool is waited for.
struct TimeLimits {
  std::chrono::seconds start{60};  ///< for the first answer of a process: Python imports
  std::chrono::seconds scene{10};
};

/// A tool that is asked scene by scene. It runs until it fails: then it is killed, and started
/// again with the next scene. Only the thread that made the session may use it.
class ToolSession {
 public:
  /// The tool's standard error is added to the file `log`.
  ToolSession(const ToolProgram& program, Level level, const std::filesystem::path& log,
              TimeLimits limits = {});

  /// The tool's answer to a scene, whatever happens to the tool. Throws ToolFailure if it has
  /// failed `most_failed_starts` times without ever answering.
  Answer ask(const TestScene& scene);

  static constexpr int most_failed_starts = 3;

 private:
  void start();
  Answer answered(const TestScene& scene);
  Answer failed(const std::string& scene);

  std::vector<std::string> command_;
  std::filesystem::path log_;
  TimeLimits limits_;
  std::optional<outside::LineProgram> process_;
  bool has_answered_ = false;  // this process
  bool has_ever_answered_ = false;
  int failed_starts_ = 0;
};

/// The answers to some scenes, in their order. Those in the file are taken from there; the others
/// are asked for and added to it one by one, so that a run which is interrupted goes on there. A
/// file whose first line is not `origin` is replaced, and a last line that is cut off is asked
/// for again.
std::vector<Answer> kept_answers(const std::filesystem::path& file, const std::string& origin,
                                 const std::vector<ScoredScene>& scenes,
                                 const std::function<Answer(const ScoredScene&)>& ask);

}  // namespace ricochet::studies::impact_test
