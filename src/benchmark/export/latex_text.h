#pragma once

#include <string>
#include <string_view>

namespace ricochet::exports {

/// The text as one line with LaTeX's special characters escaped; needs textcomp and T1 fonts.
std::string latex_text(std::string_view text);

}  // namespace ricochet::exports
