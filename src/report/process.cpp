#include "src/report/process.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <system_error>

namespace ricochet::report {
namespace {

void require(bool done, int code, const char* what) {
  if (!done) throw std::system_error(code, std::generic_category(), what);
}

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// A file in memory. Files instead of pipes: nobody waits for a reader, so nothing can deadlock,
/// and a program that ends without reading its input raises no SIGPIPE here.
using MemoryFile = std::unique_ptr<std::FILE, Close>;

MemoryFile memory_file(const std::string& text) {
  MemoryFile file(fdopen(memfd_create("ricochet", MFD_CLOEXEC), "w+"));
  require(file != nullptr, errno, "memfd_create");
  const bool written = std::fwrite(text.data(), 1, text.size(), file.get()) == text.size();
  require(written && std::fflush(file.get()) == 0, errno, "fwrite");
  std::rewind(file.get());
  return file;
}

std::string read_all(const MemoryFile& file) {
  std::fseek(file.get(), 0, SEEK_END);
  std::string text(static_cast<std::size_t>(std::ftell(file.get())), '\0');
  std::rewind(file.get());
  text.resize(std::fread(text.data(), 1, text.size(), file.get()));
  return text;
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& arguments, const std::string& input,
                          std::chrono::duration<double> limit) {
  const MemoryFile files[] = {memory_file(input), memory_file(""), memory_file("")};
  // In the foreground: an interrupt from the keyboard shall reach the program too.
  std::vector<std::string> all{"/usr/bin/timeout", "--foreground", "--verbose", "--kill-after=5",
                               fmt::format("{}", limit.count())};
  all.insert(all.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& argument : all) argv.push_back(argument.data());
  argv.push_back(nullptr);
  const char* search = std::getenv("PATH");
  // The locale is fixed: gnuplot measures text by it.
  std::string locale = "LC_ALL=C.UTF-8";
  std::string path = std::string("PATH=") + (search ? search : "/usr/bin:/bin");
  char* environment[] = {path.data(), locale.data(), nullptr};

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_adddup2(&actions, fileno(files[standard].get()), standard);
  pid_t child = 0;
  // What ends this program tidily is blocked here; there it shall act as the system has it.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  const int code = posix_spawn(&child, argv[0], &actions, &attributes, argv.data(), environment);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  require(code == 0, code, argv[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0) require(errno == EINTR, errno, "waitpid");
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_all(files[1]),
          read_all(files[2])};
}

}  // namespace ricochet::report
