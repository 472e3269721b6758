#pragma once

#include "src/report/json.h"

namespace ricochet::studies::comparison {

/// Returns short questions with their answers, for a front page: a list of {problem, answer, links:
/// [{text, to}]}, from the data of the report with its pages. A question that the data cannot
/// answer is left out.
report::Json answers_data(const report::Json& all);

}  // namespace ricochet::studies::comparison
