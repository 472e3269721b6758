#pragma once

#include <vector>

#include "src/report/json.h"
#include "src/studies/contest/field.h"

namespace ricochet::studies::contest {

/// For every field that is compared, question by question how many times the evaluations of the one
/// the other of its best two needs, and which of them solves it: bars, rising.
report::Json log_ratio_data(const Campaign& campaign, const std::vector<Field>& fields);

}  // namespace ricochet::studies::contest
