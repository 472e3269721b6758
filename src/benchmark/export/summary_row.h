#pragma once

#include <string>
#include <vector>

#include "src/benchmark/analysis/judged_runs.h"
#include "src/benchmark/analysis/result.h"

namespace ricochet::exports {

/// The row of a cell in a printed table, not yet escaped for a language.
struct SummaryRow {
  std::vector<std::string> names;    ///< as named in summary_names
  std::vector<std::string> figures;  ///< as named in summary_figures
  int failed = 0;                    ///< runs that ended in an exception
};

std::vector<std::string> summary_names();
std::vector<std::string> summary_figures();

/// One sentence for each figure, for the text below or above the table.
std::string summary_legend();

/// The expected running time is "-" if unknown, because no run solved the problem.
SummaryRow summary_row(const comparison::JudgedCell& cell);

}  // namespace ricochet::exports
