#pragma once

#include "src/contest/stored_contest.h"
#include "src/report/json.h"

namespace ricochet::studies::contest {

using namespace ricochet::contest;

/// What features do to solvers, family by family, each in the form that it does best in under all
/// features together, with the largest budget; "plain" is compared on what a feature was tried on:
/// - `features`: a row for each feature: means over solvers with and without it, how many it harms
///   for sure, which of them most, and who solves most under it;
/// - `feature_rows`: a row for each solver, with a share of runs solved for each feature;
/// - `atlas`: of every machine and feature what became of the runs, and a command that makes one of
///   the failed ones again.
/// Empty lists where the campaign has no feature but "plain".
report::Json feature_data(const Campaign& campaign, const std::vector<StoredStanding>& standings);

}  // namespace ricochet::studies::contest
