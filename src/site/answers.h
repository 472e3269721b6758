#pragma once

#include "src/site/found_report.h"

namespace ricochet::site {

/// How fast the paper's machines may turn: a row for each restitution and friction, with the least
/// and the greatest threshold over the disturbances [rad/s and rpm], and the paper's. Null where
/// there is no reproduction.
Json speed_answer(const std::vector<FoundReport>& reports);

/// The headlines of the machines that were asked about.
Json machine_answers(const std::vector<FoundReport>& reports);

/// Who is most probably the best, by family of questions and budget, and the places of solvers from
/// outside. Null where there is no contest.
Json solver_answer(const std::vector<FoundReport>& reports);

/// The contest of most runs; nothing where there is none.
const FoundReport* largest_contest(const std::vector<FoundReport>& reports);

}  // namespace ricochet::site
