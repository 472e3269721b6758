#pragma once

#include <optional>
#include <string>

namespace ricochet {

/// Messages of bytes over a pipe, each after its length: the processes of a campaign under MPI
/// exchange them.

/// Writes all of a message. Returns false if no one reads any more.
bool write_frame(int descriptor, const std::string& message);

/// Waits for a message. Returns nothing if the sender has closed the pipe, also within a message.
std::optional<std::string> read_frame(int descriptor);

/// The file descriptor for the messages that a server of a campaign writes; it reads messages from
/// standard input.
inline constexpr int frames_out = 3;

}  // namespace ricochet
