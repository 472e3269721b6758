#pragma once

#include <vector>

#include "src/report/json.h"
#include "src/studies/contest/field.h"

namespace ricochet::studies::contest {

/// For every field that is compared, whose solver is ahead at which cost of a simulation, with a
/// gradient that is free, at its measured price and at n evaluations: rows with the stretches, and
/// the curves of whoever is ahead somewhere. The runs are those at the price n, only what they
/// asked for is priced anew.
report::Json break_even_data(const Campaign& campaign, const std::vector<Field>& fields);

}  // namespace ricochet::studies::contest
