#pragma once

#include <optional>
#include <vector>

#include "src/analysis/comparison/group.h"
#include "src/analysis/comparison/reported_part.h"
#include "src/report/results.h"

namespace ricochet::studies::comparison {

using namespace ricochet::comparison;

/// Expected running time: evaluations per variable until the problem is solved, with restarts;
/// infinite if no run solved it.
double running_time(const Campaign& campaign, const CellResult& result);

/// Penalised cost of a run with this budget: evaluations until it solved its problem, at least 1;
/// if it did not, ten times the budget (PAR10; Lindauer, van Rijn and Kotthoff 2019,
/// doi:10.1016/j.artint.2018.10.004).
double penalised_cost(const Outcome& outcome, double budget);

/// That of a solver on a problem: per variable, mean over its runs.
double penalised_cost(const Campaign& campaign, const CellResult& result);

/// Returns the entries sorted by the geometric mean of their penalised costs, least first.
std::vector<const Entry*> cheapest_first(const Campaign& campaign, const EntrySet& set);

/// Adds what compares the entries of a set on which a run solved its problem, to a family's page:
/// table "profile" and chart "profile", performance profiles of the expected running times, the six
/// entries with the least penalised cost in the chart; for all entries the share of problems within
/// a factor of the least, and the ratio of its penalised cost to the virtual best solver's; the
/// value "virtual-best" says the single best in words.
void add_profiles(const Campaign& campaign, const EntrySet& set, report::Results& page);

/// Adds how accurate the ranked entries of a group are with the largest budget, whatever the
/// problems' tolerances: chart "quality", and parts "precisions", one for each tau of 1e-1, 1e-3,
/// 1e-5 and 1e-7, with a data profile and the table "accuracy". A run reaches a precision if the
/// gap of its returned point, see merit_gap(), is at most tau times that of its start (Moré and
/// Wild 2009, doi:10.1137/080724083).
void add_accuracy(const RatedPart& part, std::size_t group, report::Results& page);

}  // namespace ricochet::studies::comparison
