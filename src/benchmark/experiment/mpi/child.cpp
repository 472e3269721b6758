#include "src/benchmark/experiment/mpi/child.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <system_error>

#include "src/benchmark/experiment/campaign/frame.h"

namespace ricochet::mpi {

Child::Child(std::vector<std::string> arguments) {
  const std::string program =
      std::filesystem::read_symlink("/proc/self/exe").replace_filename("ricochet").string();
  arguments.insert(arguments.begin(), program);
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  int in[2];
  int out[2];
  if (pipe2(in, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  if (pipe2(out, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGTERM);  // a rank that is killed leaves nothing behind
    if (getppid() != parent) _exit(127);
    dup2(in[0], STDIN_FILENO);
    dup2(out[1], frames_out);
    fcntl(frames_out, F_SETFD, 0);
    execv(program.c_str(), argv.data());
    _exit(127);
  }
  const int error = errno;
  close(in[0]);
  close(out[1]);
  to_ = in[1];
  from_ = out[0];
  if (process_ < 0) throw std::system_error(error, std::generic_category(), "fork");
}

Child::~Child() {
  wait();
  close(from_);
}

bool Child::tell(const std::string& message) {
  return write_frame(to_, message);
}

bool Child::waits_for_news(std::chrono::milliseconds most) {
  pollfd news{from_, POLLIN, 0};
  return poll(&news, 1, static_cast<int>(most.count())) > 0;
}

std::optional<std::string> Child::hear() {
  return read_frame(from_);
}

int Child::wait() {
  if (to_ >= 0) close(to_);
  to_ = -1;
  if (process_ < 0) return 0;
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace ricochet::mpi
