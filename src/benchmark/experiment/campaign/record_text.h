#pragma once

#include <string>

#include "src/core/run.h"

namespace ricochet {

/// What a process tells another of a run: bytes that keep every bit of every number, NaN and
/// infinity too.
std::string text_of(const RunRecord& record);
std::string text_of(const Improvement& improvement);

/// Either of them, read again. Throws std::exception where the text is neither.
RunRecord record_from(const std::string& text);
Improvement improvement_from(const std::string& text);

}  // namespace ricochet
