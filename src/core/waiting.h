#pragma once

#include <functional>
#include <string>

namespace ricochet {

/// Tells that this thread has waited long for something outside the program, such as "waiting for
/// python3 mine.py; last line received: ..."; an empty text tells that the wait is over. A text is
/// written to standard error as a line.
void tell_waiting(const std::string& text);

/// From now on tell_waiting() also calls this. Must be called before a second thread waits.
void on_waiting(std::function<void(const std::string&)> told);

}  // namespace ricochet
