#pragma once

#include <string>

#include "src/report/json.h"

namespace ricochet::studies::comparison {

/// Returns short questions with their answers, for a front page: a list of {problem, answer, links:
/// [{text, to}]}, from the data of the report with its pages. A question that the data cannot
/// answer is left out.
report::Json answers_data(const report::Json& all);

/// The first sentences of a comparison's report: which solver, how sure, on how many problems. Of
/// the rows of leader_data() those with the largest budgets.
std::string opening_of(const report::Json& leaders);

}  // namespace ricochet::studies::comparison
