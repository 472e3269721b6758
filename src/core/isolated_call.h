#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace ricochet {

/// The text that `work` returns in a child process with so much memory [MB] besides this one's. The
/// child, whose streams lead nowhere, and all that it starts are gone afterwards. Throws
/// std::runtime_error with the message of what `work` throws, or if the child crashes or takes
/// longer than the limit.
std::string called_in_isolation(const std::function<std::string()>& work,
                                std::chrono::seconds limit, double megabytes);

}  // namespace ricochet
