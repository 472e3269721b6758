#include "src/report/process.h"

#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

namespace ricochet::report {
namespace {

[[noreturn]] void fail(int code, const std::string& what) {
  throw std::system_error(code, std::generic_category(), what);
}

/// A file in memory. Files instead of pipes: nobody waits for a reader, so nothing can deadlock,
/// and a program that ends without reading its input raises no SIGPIPE here.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(memfd_create("ricochet", MFD_CLOEXEC)) {
    if (descriptor_ < 0) fail(errno, "memfd_create");
  }
  ~MemoryFile() { close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  int descriptor() const { return descriptor_; }

  void write_and_rewind(const std::string& text) {
    std::size_t done = 0;
    while (done < text.size()) {
      const ssize_t n = ::write(descriptor_, text.data() + done, text.size() - done);
      if (n < 0 && errno != EINTR) fail(errno, "write");
      if (n > 0) done += static_cast<std::size_t>(n);
    }
    lseek(descriptor_, 0, SEEK_SET);
  }

  std::string read_all() const {
    std::string text(static_cast<std::size_t>(lseek(descriptor_, 0, SEEK_END)), '\0');
    std::size_t done = 0;
    while (done < text.size()) {
      const ssize_t n =
          pread(descriptor_, text.data() + done, text.size() - done, static_cast<off_t>(done));
      if (n == 0) break;
      if (n < 0 && errno != EINTR) fail(errno, "read");
      if (n > 0) done += static_cast<std::size_t>(n);
    }
    text.resize(done);
    return text;
  }

 private:
  int descriptor_;
};

}  // namespace

ProcessResult run_process(const std::vector<std::string>& arguments, const std::string& input) {
  MemoryFile in, out, err;
  in.write_and_rewind(input);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in.descriptor(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out.descriptor(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err.descriptor(), STDERR_FILENO);
  std::vector<char*> argv;
  for (const std::string& argument : arguments)
    argv.push_back(const_cast<char*>(argument.c_str()));  // posix_spawn does not write to it
  argv.push_back(nullptr);
  const char* search = std::getenv("PATH");
  // The locale is fixed: gnuplot measures text by it.
  std::string locale = "LC_ALL=C.UTF-8";
  std::string path = std::string("PATH=") + (search ? search : "/usr/bin:/bin");
  char* environment[] = {path.data(), locale.data(), nullptr};

  pid_t child = 0;
  const int code = posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environment);
  posix_spawn_file_actions_destroy(&actions);
  if (code != 0) fail(code, arguments.front() + " cannot be started");

  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) fail(errno, "waitpid");
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), out.read_all(),
          err.read_all()};
}

}  // namespace ricochet::report
