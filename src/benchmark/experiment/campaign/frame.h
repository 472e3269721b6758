#pragma once

#include <optional>
#include <string>

namespace ricochet {

/// Messages of bytes over a pipe, each behind its length: what the processes of a campaign under
/// MPI tell each other.

/// Writes all of a message. Returns whether there is still somebody who reads.
bool write_frame(int descriptor, const std::string& message);

/// Waits for a message. Nothing where there comes none any more, or only a part of one.
std::optional<std::string> read_frame(int descriptor);

/// The descriptor on which a server of a campaign writes its messages; it reads them on standard
/// input.
inline constexpr int frames_out = 3;

}  // namespace ricochet
