#pragma once

#include <string>
#include <vector>

#include "src/contest/result.h"
#include "src/export/judged_runs.h"

namespace ricochet::exports {

/// What a printed table says of a cell, not yet escaped for a language.
struct SummaryRow {
  std::vector<std::string> names;    ///< as named in summary_names
  std::vector<std::string> figures;  ///< as named in summary_figures
  int failed = 0;                    ///< runs that ended in an exception
};

std::vector<std::string> summary_names();
std::vector<std::string> summary_figures();

/// What the figures are, in one sentence each, for below or above the table.
std::string summary_legend();

/// "-" where the expected running time is unknown, as nothing was solved.
SummaryRow summary_row(const JudgedCell& cell);

}  // namespace ricochet::exports
