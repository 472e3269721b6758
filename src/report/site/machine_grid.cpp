#include "src/report/site/machine_grid.h"

#include <fmt/format.h>

namespace ricochet::site {
namespace {

constexpr const char* grid_family = "top-speed-machines";

}  // namespace

std::optional<MachineGrid> machine_grid(const std::vector<FoundReport>& reports) {
  for (const FoundReport& report : reports) {
    for (const FoundPage& page : report.pages) {
      const auto machines = page.data.find("machines");
      if (machines == page.data.end() || !machines->is_array()) continue;
      for (const Json& one : *machines) {
        try {
          if (one.at("family") == grid_family) return one.get<MachineGrid>();
        } catch (const Json::exception&) {  // of another version
        }
      }
    }
  }
  return std::nullopt;
}

std::string row_label(double friction, double restitution) {
  return fmt::format("friction {}, restitution {}", friction, restitution);
}

std::optional<double> with_restitution(const MachineGrid& grid, const PaperMachine& machine,
                                       double restitution) {
  for (const GridRow& row : grid.known) {
    if (row.machine != row_label(machine.friction, restitution)) continue;
    for (std::size_t i = 0; i < grid.columns.size() && i < row.cells.size(); ++i) {
      const bool own = grid.columns[i].level == fmt::format("{}", machine.disturbance);
      if (own && !row.cells[i].is_null()) return row.cells[i].get<double>();
    }
  }
  return std::nullopt;
}

}  // namespace ricochet::site
