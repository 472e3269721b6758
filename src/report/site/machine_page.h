#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/report/site/entries.h"
#include "src/report/site/navigation.h"
#include "src/report/site/paper_machines.h"

namespace ricochet::site {

/// The page about the machine: what moves its threshold, the thresholds of the paper's machines and
/// of those between, and how to compute one's own. The latter are from a comparison with machines
/// on a grid, if one of the reports has it.
OwnPage machine_page(const PaperMachines& machines, const std::vector<FoundReport>& reports);

struct GridLevel {
  std::string level;
};

struct GridRow {
  std::string machine;  ///< "friction 0.4, restitution 0.5"
  Json cells;           ///< a threshold [rad/s] for each level, or null
};

/// Machines on a grid of restitution, friction and disturbance: the best known value of the problem
/// of each, which is its fastest quiet speed.
struct MachineGrid {
  std::string column;  ///< the constant of the columns
  std::vector<GridLevel> columns;
  std::vector<GridRow> known;
};
RICOCHET_FIELDS(GridLevel, level);
RICOCHET_FIELDS(GridRow, machine, cells);
RICOCHET_FIELDS(MachineGrid, column, columns, known);

/// Returns the grid of a comparison; nothing if no report has one that can be read.
std::optional<MachineGrid> machine_grid(const std::vector<FoundReport>& reports);

/// Label of a row of the grid.
std::string row_label(double friction, double restitution);

/// Threshold [rad/s] of a machine with another restitution; nothing if the grid lacks it.
std::optional<double> with_restitution(const MachineGrid& grid, const PaperMachine& machine,
                                       double restitution);

}  // namespace ricochet::site
