#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

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
  std::vector<std::string> pip;       ///< of Python, where Debian has none
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

}  // namespace ricochet::studies::impact_test
