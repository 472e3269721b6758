#include "src/core/isolated_call.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <system_error>

#include "src/core/open_files.h"
#include "src/core/resource_limits.h"
#include "src/core/supervised_process.h"

namespace ricochet {
namespace {

using Clock = std::chrono::steady_clock;

// The first byte of an answer; one without is of a child that did not end by itself.
constexpr char returned = 'r';
constexpr char thrown = 't';

std::string answer_of(const std::function<std::string()>& work) {
  try {
    return returned + work();
  } catch (const std::exception& error) {
    return thrown + std::string(error.what());
  } catch (...) {
    return thrown + std::string("threw what is no std::exception");
  }
}

/// The main function of the child.
[[noreturn]] void work_and_answer(const std::function<std::string()>& work, double megabytes,
                                  int descriptor) {
  limit_resources(megabytes);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) lead_nowhere(stream);
  const std::string answer = answer_of(work);
  for (std::size_t done = 0; done < answer.size();) {
    const ssize_t count = write(descriptor, answer.data() + done, answer.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    done += static_cast<std::size_t>(count);
  }
  _exit(0);
}

/// Reads to the end of the stream. Returns false if that did not come in time.
bool read_all(int descriptor, Clock::time_point deadline, std::string& text) {
  for (;;) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
    pollfd end{descriptor, POLLIN, 0};
    const int news = poll(&end, 1, static_cast<int>(std::max<std::int64_t>(left.count(), 0)));
    if (news == 0) return false;
    char piece[4096];
    const ssize_t count = read(descriptor, piece, sizeof piece);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return true;
    text.append(piece, static_cast<std::size_t>(count));
  }
}

}  // namespace

std::string called_in_isolation(const std::function<std::string()>& work,
                                std::chrono::seconds limit, double megabytes) {
  int ends[2] = {};
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  std::fflush(nullptr);  // buffered output is the parent's to write
  std::string answer;
  bool in_time = false;
  int status = 0;
  try {
    SupervisedProcess process([&] {
      close(ends[0]);
      work_and_answer(work, megabytes, ends[1]);
    });
    close(ends[1]);
    ends[1] = -1;
    in_time = read_all(ends[0], Clock::now() + limit, answer);
    status = process.end();
  } catch (...) {
    close(ends[0]);
    if (ends[1] >= 0) close(ends[1]);
    throw;
  }
  close(ends[0]);
  if (!in_time) throw std::runtime_error(fmt::format("took more than {} s", limit.count()));
  if (answer.empty()) throw std::runtime_error(ending_in_words(status));
  if (answer[0] == thrown) throw std::runtime_error(answer.substr(1));
  return answer.substr(1);
}

}  // namespace ricochet
