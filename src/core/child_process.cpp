#include "src/core/child_process.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <system_error>

namespace ricochet {

namespace {

using Clock = std::chrono::steady_clock;
using Length = std::uint64_t;

/// A longer message comes from a broken process [bytes].
constexpr Length longest_message = Length{1} << 30;

/// Milliseconds for poll() until then; at most an hour, so that they fit into an int.
int milliseconds_until(Clock::time_point until) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now());
  return static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, 3'600'000));
}

}  // namespace

void Descriptor::close() {
  if (number_ >= 0) ::close(number_);
  number_ = -1;
}

void Descriptor::take(int number) {
  close();
  number_ = number;
}

bool write_frame(int descriptor, std::string_view message) {
  const Length length = message.size();
  std::string bytes(sizeof length, '\0');
  std::memcpy(bytes.data(), &length, sizeof length);
  bytes += message;
  for (std::size_t sent = 0; sent < bytes.size();) {
    // Without a signal if nobody reads, where it is a socket.
    ssize_t count = send(descriptor, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (count < 0 && errno == ENOTSOCK) {
      count = write(descriptor, bytes.data() + sent, bytes.size() - sent);
    }
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    sent += static_cast<std::size_t>(count);
  }
  return true;
}

bool FrameReader::read_from(int descriptor) {
  char piece[1 << 16];
  const ssize_t count = read(descriptor, piece, sizeof piece);
  if (count < 0 && errno == EINTR) return true;
  if (count <= 0) return false;
  unread_.append(piece, static_cast<std::size_t>(count));
  Length length = 0;
  if (unread_.size() < sizeof length) return true;
  std::memcpy(&length, unread_.data(), sizeof length);
  return length <= longest_message;
}

std::optional<std::string> FrameReader::next() {
  Length length = 0;
  if (unread_.size() < sizeof length) return std::nullopt;
  std::memcpy(&length, unread_.data(), sizeof length);
  if (length > longest_message || unread_.size() - sizeof length < length) return std::nullopt;
  std::string message = unread_.substr(sizeof length, length);
  unread_.erase(0, sizeof length + length);
  return message;
}

std::optional<std::string> read_frame(int descriptor) {
  const auto read_all = [descriptor](char* bytes, std::size_t count) {
    while (count > 0) {
      const ssize_t taken = read(descriptor, bytes, count);
      if (taken < 0 && errno == EINTR) continue;
      if (taken <= 0) return false;
      bytes += taken;
      count -= static_cast<std::size_t>(taken);
    }
    return true;
  };
  char head[sizeof(Length)];
  if (!read_all(head, sizeof head)) return std::nullopt;
  Length length = 0;
  std::memcpy(&length, head, sizeof head);
  if (length > longest_message) return std::nullopt;
  std::string message(length, '\0');
  if (!read_all(message.data(), message.size())) return std::nullopt;
  return message;
}

ChildProcess::ChildProcess(const std::function<void(int descriptor)>& work) {
  int ends[2] = {};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    throw std::system_error(errno, std::generic_category(), "socketpair");
  }
  channel_.take(ends[0]);
  const Descriptor other(ends[1]);
  std::fflush(nullptr);  // buffered output is the parent's to write
  process_.emplace([&] {
    channel_.close();
    work(other.number());
  });
}

bool ChildProcess::has_news(Clock::time_point until) const {
  pollfd news{descriptor(), POLLIN, 0};
  int count = 0;
  do {
    count = poll(&news, 1, milliseconds_until(until));
  } while (count < 0 && errno == EINTR);
  return count > 0;
}

std::optional<std::string> ChildProcess::hear() {
  for (;;) {
    if (auto message = next()) return message;
    if (!listen()) return std::nullopt;
  }
}

int ChildProcess::finish() {
  shutdown(descriptor(), SHUT_WR);
  return process_->wait();
}

namespace {

// The first byte of an answer; none comes from a child that did not end by itself.
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

}  // namespace

std::string called_in_isolation(const std::function<std::string()>& work,
                                std::chrono::seconds limit, double megabytes) {
  const auto deadline = Clock::now() + limit;
  ChildProcess child([&](int descriptor) {
    limit_resources(megabytes);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) lead_nowhere(stream);
    write_frame(descriptor, answer_of(work));
    _exit(0);
  });
  std::optional<std::string> answer;
  while (!(answer = child.next())) {
    if (!child.has_news(deadline)) {
      throw std::runtime_error(fmt::format("took more than {} s", limit.count()));
    }
    if (!child.listen()) break;
  }
  if (!answer || answer->empty()) throw std::runtime_error(ending_in_words(child.end()));
  if (answer->front() == thrown) throw std::runtime_error(answer->substr(1));
  return answer->substr(1);
}

}  // namespace ricochet
