#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "src/studies/contest/reported_part.h"

namespace ricochet::studies::contest {

/// What a competitor did on one question, mean over its runs.
struct MachineResult {
  const Question* question;
  double solved = 0;    ///< share
  double cost = 0;      ///< log10 of the evaluations until solved, or in all
  double accuracy = 0;  ///< share of the question's targets reached
};

/// What competitors, by solver and form, did on the questions of a family.
using ByCompetitor = std::map<std::pair<std::string, std::string>, std::vector<MachineResult>>;

/// By family, what each competitor did on the questions of a part that are asked of machines.
std::map<std::string, ByCompetitor> machine_results(const Campaign& campaign,
                                                    const std::vector<StoredStanding>& standings,
                                                    const ReportedPart& part);

/// The factors of a family's machines that have several levels, with their levels; none where there
/// are no more machines than such factors, which cannot tell one from another.
std::map<std::string, std::vector<double>> factors_of(const ByCompetitor& competitors);

double mean_solved(const std::vector<MachineResult>& results);

/// The competitors of a family, most solved first.
std::vector<const ByCompetitor::value_type*> best_first(const ByCompetitor& competitors);

std::string name_of(const ByCompetitor::value_type& competitor);

/// Of a factor: a number, or the name of a fidelity.
std::string level_name(const std::string& factor, double level);

}  // namespace ricochet::studies::contest
