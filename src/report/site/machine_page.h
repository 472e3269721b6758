#pragma once

#include <vector>

#include "src/report/site/own_page.h"
#include "src/report/site/paper_machines.h"

namespace ricochet::site {

/// The page about the machine: what moves its threshold, the thresholds of the paper's machines and
/// of those between, and how to compute one's own. The latter are from a comparison with machines
/// on a grid, if one of the reports has it.
OwnPage machine_page(const PaperMachines& machines, const std::vector<FoundReport>& reports);

}  // namespace ricochet::site
