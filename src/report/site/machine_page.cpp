#include "src/report/site/machine_page.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "src/report/text.h"

namespace ricochet::site {

namespace {

/// The paper's machines of a row of the grid, without disturbance and with it.
std::string cases_of(const std::vector<PaperMachine>& machines, const std::string& row) {
  std::string ids;
  for (const PaperMachine& one : machines) {
    if (row != row_label(one.friction, one.restitution)) continue;
    ids += (ids.empty() ? "" : ", ") + one.id;
  }
  return ids;
}

report::Table grid_table(const MachineGrid& grid, const std::vector<PaperMachine>& machines) {
  report::Table table{
      "Fastest quiet speed [rad/s] over restitution, friction and disturbance [N]: the "
      "paper's values, and restitutions between.",
      {{"machine", report::Alignment::left}, {"the paper's", report::Alignment::left}},
      {}};
  for (const GridLevel& level : grid.columns) {
    table.columns.push_back({grid.column + " " + level.level});
  }
  for (const GridRow& row : grid.known) {
    std::vector<report::Cell> cells = {{row.machine}, {cases_of(machines, row.machine)}};
    for (const Json& value : row.cells) {
      cells.push_back({value.is_null() ? "–" : fmt::format("{:.2f}", value.get<double>())});
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

report::Table machines_table(const PaperMachines& all) {
  report::Table table{
      "Long run: silent up to the first speed, quiet up to the second. The paper gives no "
      "threshold for C11 and C12.",
      {{"case", report::Alignment::left},
       {"restitution"},
       {"friction"},
       {"disturbance [N]"},
       {"silent up to [rad/s]"},
       {"quiet up to [rad/s]"},
       {"paper's threshold [rad/s]"},
       {"difference"}},
      {}};
  for (const PaperMachine& one : all.machines) {
    const bool both = one.quiet_up_to && one.paper_threshold;
    table.rows.push_back(
        {{.text = one.id, .link = "../" + all.folder},
         {fmt::format("{}", one.restitution)},
         {fmt::format("{}", one.friction)},
         {fmt::format("{}", one.disturbance)},
         {report::text_or_dash(one.silent_up_to, "{:.2f}")},
         {report::text_or_dash(one.quiet_up_to, "{:.2f}")},
         {one.paper_threshold ? fmt::format("{}", *one.paper_threshold) : "none given"},
         {both ? fmt::format("{:+.0f} %", 100 * (*one.quiet_up_to / *one.paper_threshold - 1))
               : "–"}});
  }
  return table;
}

report::Section own_section() {
  return {.id = "own",
          .heading = "A machine of your own",
          .paragraphs = {"Describe it in a file, and ask for its fastest quiet speed, with the "
                         "uncertainty of its constants; or set one constant of a case of the "
                         "paper."},
          .code = {"./ricochet machine new > machine.toml\n"
                   "./ricochet machine advise machine.toml\n"
                   "./ricochet threshold --case C4 --set restitution=0.5"}};
}

}  // namespace

OwnPage machine_page(const PaperMachines& machines, const std::vector<FoundReport>& reports) {
  OwnPage own{{"Machine", "Speeds of the machine", "machine"}, {}};
  own.page.title = "How fast may the machine turn?";
  own.page.intro = {speed_sentence(machines)};
  own.page.above = "the front page";
  report::Section moves{.id = "what-if",
                        .heading = "What moves the threshold?",
                        .paragraphs = {effects_sentence(machines)}};
  if (const auto grid = machine_grid(reports)) {
    moves.tables.push_back(grid_table(*grid, machines.machines));
  }
  for (const report::Chart& chart : machines.charts) moves.figures.push_back({chart, ""});
  own.page.sections.push_back(std::move(moves));
  own.page.sections.push_back({.id = "machines",
                               .heading = "The paper's machines",
                               .paragraphs = {agreement_sentence(machines)},
                               .tables = {machines_table(machines)},
                               .figures = {{regimes_chart(machines), ""}}});
  own.page.sections.push_back(own_section());
  return own;
}

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
