#include "src/benchmark/experiment/campaign/frame.h"

#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>

namespace ricochet {
namespace {

/// Upper limit of a message's length [bytes].
constexpr std::uint64_t longest = 1ULL << 30;

bool read_all(int descriptor, char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t taken = read(descriptor, bytes, count);
    if (taken < 0 && errno == EINTR) continue;
    if (taken <= 0) return false;
    bytes += taken;
    count -= static_cast<std::size_t>(taken);
  }
  return true;
}

}  // namespace

bool write_frame(int descriptor, const std::string& message) {
  const std::uint64_t length = message.size();
  std::string bytes(sizeof length, '\0');
  std::memcpy(bytes.data(), &length, sizeof length);
  bytes += message;
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t count = write(descriptor, bytes.data() + sent, bytes.size() - sent);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    sent += static_cast<std::size_t>(count);
  }
  return true;
}

std::optional<std::string> read_frame(int descriptor) {
  char head[sizeof(std::uint64_t)];
  if (!read_all(descriptor, head, sizeof head)) return std::nullopt;
  std::uint64_t length = 0;
  std::memcpy(&length, head, sizeof head);
  if (length > longest) return std::nullopt;
  std::string message(length, '\0');
  if (!read_all(descriptor, message.data(), message.size())) return std::nullopt;
  return message;
}

}  // namespace ricochet
