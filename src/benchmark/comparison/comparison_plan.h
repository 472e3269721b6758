#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/benchmark/experiment/campaign/campaign.h"

namespace ricochet::studies {

/// What is compared; patterns are shell patterns, separated by commas.
struct ComparisonOptions {
  std::string problems;  ///< names of problems; empty: those of the default comparison
  std::string solvers = "*";
  /// Solvers that are included whatever the patterns select: names, or files and programs of the
  /// user; see solvers/outside/outside.h.
  std::vector<std::string> added_solvers = {};
  std::string formulations = "*";
  std::vector<std::int64_t>
      budgets;  ///< evaluations per variable; empty: those of the default comparison
  std::vector<double> smoothings;  ///< of surrogates, in addition to the default one
  int instances = 15;
  Limits limits;  ///< of every run
  /// Text of a machine file: its problems of one variable, whose names end in -scene, all if
  /// `problems` is empty; empty: the problems of the suite.
  std::string scene = {};
};

/// Returns the plan for these options. Throws InputError if a pattern matches nothing.
Plan comparison_plan(const ComparisonOptions& options, bool quick, const Catalogue& catalogue);

}  // namespace ricochet::studies
