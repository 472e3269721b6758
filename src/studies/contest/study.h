#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/campaign/campaign.h"
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

/// What these options ask for as a plan. Throws InputError for patterns that nothing fits.
Plan contest_plan(const ContestOptions& options, bool quick, const Catalogue& catalogue);

/// What a campaign says once all its runs are made: who solves what, in which form, how surely, at
/// what cost; what features, prices and machines do to it; and whether the order would be another
/// with other instances, seeds and budgets. `wider` makes further runs, which are not kept: with
/// machines drawn around the cases, and with the best point elsewhere in the box. Both outlive it.
Study contest_study(const Campaign& campaign, const Store& store, bool wider);

}  // namespace ricochet::studies
