#include "src/app/other_program.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "src/app/command_line.h"
#include "src/core/progress.h"

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

std::string shell_quoted(std::string_view word) {
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

std::string output_of(const OtherCommand& other, const std::string& argument) {
  const std::string command =
      fmt::format("{} {} 2>/dev/null", shell_quoted(path_of(other)), shell_quoted(argument));
  std::FILE* output = popen(command.c_str(), "re");
  if (output == nullptr) return "";
  std::string text;
  char part[4096];
  for (std::size_t size = 0; (size = std::fread(part, 1, sizeof part, output)) > 0;)
    text.append(part, size);
  return pclose(output) == 0 ? text : "";
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

void add_other(CommandLine& line, const OtherCommand& other) {
  line.start_group(other.group);
  CLI::App* command = line.add(other.command, other.summary);
  command->set_help_flag();
  for (CLI::Option* option : command->get_options()) command->remove_option(option);
  command->prefix_command();
  line.on_call(command, [other, command]() -> int { hand_over(other, command->remaining()); });
}

Provenance provenance() {
  utsname machine{};
  uname(&machine);
  return {{{"version", version()}},
          {{"machine", fmt::format("{} {}, {}", machine.sysname, machine.release, machine.machine)},
           {"cores", std::to_string(cores())},
           {"date", fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)))}}};
}

}  // namespace ricochet::cli
