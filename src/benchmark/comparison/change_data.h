#pragma once

#include "src/benchmark/comparison/reported_part.h"
#include "src/report/json.h"

namespace ricochet::studies::comparison {

/// For each part and family: which entry is first, with the largest budget and without
/// perturbations, and how well the order of the entries agrees with that of the first setting:
/// - for each price of a gradient, if a part has several;
/// - for the surrogate of each smoothing parameter, the default one first;
/// - on the machines of each level of a factor that varies from machine to machine, such as the
///   fidelity of the simulation, the lowest level first.
report::Json change_data(const Campaign& campaign, const std::vector<CellResult>& results,
                         const std::vector<ReportedPart>& parts);

}  // namespace ricochet::studies::comparison
