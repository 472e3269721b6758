#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "src/core/process.h"

/// Processes of our own, which exchange frames: messages of bytes, each after its length of eight
/// bytes. Programs of strangers exchange lines of JSON instead, see line_solver.h.
namespace ricochet {

/// A file descriptor that is closed on destruction.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }
  void close();
  void take(int number);
  int release() { return std::exchange(number_, -1); }

 private:
  int number_;  // -1: none
};

/// Writes all of a message. Returns false if no one reads any more.
bool write_frame(int descriptor, std::string_view message);

/// Takes frames from what arrives in pieces of any length.
class FrameReader {
 public:
  /// Waits for bytes and takes them. Returns false if the sender has closed the stream, or if what
  /// it has sent is no frame.
  bool read_from(int descriptor);

  /// The next message that is there as a whole.
  std::optional<std::string> next();

 private:
  std::string unread_;
};

/// Waits for a message. Returns nothing if the sender has closed the stream, also within a message.
std::optional<std::string> read_frame(int descriptor);

/// The file descriptor for the frames that a program of ours writes; it reads frames from standard
/// input.
inline constexpr int frames_out = 3;

/// A supervised child with which this process exchanges frames.
class ChildProcess {
 public:
  /// Calls `work` in the child with its end of the channel; it should not return. Throws
  /// std::system_error if no process can be started.
  explicit ChildProcess(const std::function<void(int descriptor)>& work);

  /// Readable when there is news.
  int descriptor() const { return channel_.number(); }

  /// Returns false if the child does not listen any more.
  bool tell(std::string_view message) { return write_frame(descriptor(), message); }

  /// Waits for news, at most until then. Returns whether there is any.
  bool has_news(std::chrono::steady_clock::time_point until) const;

  /// Takes the news. Returns false if the child is at its end, or sends what is no frame.
  bool listen() { return reader_.read_from(descriptor()); }

  /// The next message that has been taken.
  std::optional<std::string> next() { return reader_.next(); }

  /// Waits for the next message; nothing if the child is at its end.
  std::optional<std::string> hear();

  /// Tells the child that there is nothing more for it, and waits for its end. Returns how it
  /// ended, as waitpid() does.
  int finish();

  /// Kills it with all that it has started. Returns the same.
  int end() { return process_->end(); }

 private:
  Descriptor channel_;
  FrameReader reader_;
  std::optional<SupervisedProcess> process_;
};

/// The text that `work` returns in a child process with so much memory [MB] besides this one's. The
/// child, whose streams lead nowhere, and all that it starts are gone afterwards. Throws
/// std::runtime_error with the message of what `work` throws, or if the child crashes or takes
/// longer than the limit.
std::string called_in_isolation(const std::function<std::string()>& work,
                                std::chrono::seconds limit, double megabytes);

}  // namespace ricochet
