#pragma once

#include <string>

namespace ricochet::report {

/// A string gnuplot takes as it is: between single quotes it knows no escapes, no macros and no
/// commands in backquotes, only the doubled quote.
std::string quoted(const std::string& text);

/// A tick's label is a format to gnuplot, so a percent sign must be doubled. It cuts formats after
/// 49 bytes, also within a character; this cuts them earlier, and shows it.
std::string quoted_tick(const std::string& text);

}  // namespace ricochet::report
