#pragma once

#include "src/report/json.h"
#include "src/studies/contest/reported_part.h"

namespace ricochet::studies::contest {

/// Who is first, with the largest budget and nothing disturbed, and how alike the order of the
/// competitors is to the first setting's, part by part and family by family:
/// - under each price of a gradient, where a part has several;
/// - shown the surrogate of each width, the usual one first;
/// - on the machines of each level of what is varied from machine to machine, such as the fidelity
///   of the simulation, the lowest level first.
report::Json change_data(const Campaign& campaign, const std::vector<StoredStanding>& standings,
                         const std::vector<ReportedPart>& parts);

}  // namespace ricochet::studies::contest
