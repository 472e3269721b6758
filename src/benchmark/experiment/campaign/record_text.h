#pragma once

#include <string>

#include "ricochet/run.h"

namespace ricochet {

/// The messages of one process to another about a run: bytes that keep every bit of every number,
/// including NaN and infinity.
std::string text_of(const RunRecord& record);
std::string text_of(const Improvement& improvement);

/// Reads either of them again. Throws std::exception if the text is neither.
RunRecord record_from(const std::string& text);
Improvement improvement_from(const std::string& text);

}  // namespace ricochet
