#include "src/cli/bench.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace ricochet::cli {

int bench(std::vector<std::string> arguments, bool json) {
  if (json) arguments.push_back("--benchmark_format=json");
  const std::string program =
      std::filesystem::read_symlink("/proc/self/exe").replace_filename("ricochet-bench").string();
  std::vector<char*> argv = {const_cast<char*>("ricochet bench")};
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  execv(program.c_str(), argv.data());  // returns only if it fails
  throw std::runtime_error("bench: " + program + ": " + std::strerror(errno));
}

}  // namespace ricochet::cli
