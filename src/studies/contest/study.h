#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/campaign/worker.h"
#include "src/studies/study.h"

namespace ricochet::studies {

/// What is compared; patterns are those of a shell, several with commas between.
struct ContestOptions {
  std::string questions;  ///< names of questions; empty: those of the standing contest
  std::string solvers = "*";
  /// Solvers that are in whatever the patterns say: names, or files and programs of the user's own;
  /// see solvers/outside/outside.h.
  std::vector<std::string> added_solvers = {};
  std::string forms = "*";
  std::vector<std::int64_t>
      budgets;  ///< evaluations for each variable; empty: as for the standing contest
  std::vector<double> widths;  ///< of surrogates, beside the usual one
  int instances = 15;
  Limits limits;  ///< of every run
};

/// Solvers compared on questions: who solves what, in which form, how surely, at what cost; and
/// whether the order would be another with other instances, seeds and budgets. Throws InputError
/// for patterns that nothing fits.
Study contest_study(const ContestOptions& options);

}  // namespace ricochet::studies
