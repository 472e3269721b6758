#pragma once

#include <span>
#include <string>

namespace ricochet::site {

/// A kind of report, as a front page and a navigation speak of it.
struct ReportKind {
  const char* name;      ///< as data.json has it in "report"
  const char* label;     ///< in the navigation
  const char* question;  ///< that it answers
  const char* command;   ///< that makes it
};

/// All kinds, in the order in which they are shown.
std::span<const ReportKind> report_kinds();

}  // namespace ricochet::site
