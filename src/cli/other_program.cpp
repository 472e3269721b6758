#include "src/cli/other_program.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "src/core/interruption.h"

namespace ricochet::cli {

const char* summary_of(const std::string& command) {
  for (const OtherCommand& other : other_commands) {
    if (other.command == command) return other.summary;
  }
  throw std::out_of_range(command);
}

std::string path_of(const OtherCommand& other) {
  return std::filesystem::read_symlink("/proc/self/exe").replace_filename(other.program).string();
}

void hand_over(const OtherCommand& other, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"ricochet", other.command});
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  const std::string program = path_of(other);
  end_at_once_when_interrupted();
  execv(program.c_str(), argv.data());  // returns only if it fails
  throw std::runtime_error(fmt::format("{}: {}: {}", other.command, program, std::strerror(errno)));
}

}  // namespace ricochet::cli
