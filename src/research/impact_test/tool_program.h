#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "src/research/impact_test/tool.h"

namespace ricochet::studies::impact_test {

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

/// Installs the packages of the tools that are missing: those of Debian by apt-get, as root or
/// through sudo; those of Python into an environment of its own in `folder`. Says what it does.
/// Throws std::runtime_error where one fails.
void install(const std::vector<Tool>& tools, const std::filesystem::path& folder);

}  // namespace ricochet::studies::impact_test
