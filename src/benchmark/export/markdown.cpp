#include "src/benchmark/export/markdown.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "src/benchmark/export/output_file.h"
#include "src/benchmark/export/summary_row.h"
#include "src/core/one_line.h"
#include "src/report/text.h"

namespace ricochet::exports {
namespace {

std::string row_of_table(const std::vector<std::string>& names,
                         const std::vector<std::string>& figures, bool failed) {
  std::vector<std::string> cells;
  for (const std::string& name : names) cells.push_back(report::escape_markdown(one_line(name)));
  cells.insert(cells.end(), figures.begin(), figures.end());
  if (failed) cells.back() = "**" + cells.back() + "**";
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

}  // namespace

void write_markdown(const Store& store, const Completeness& completeness,
                    const std::filesystem::path& folder) {
  OutputFile file(folder / "table.md");
  const std::string runs = report::escape_markdown(as_sentence(completeness));
  file.write((completeness.is_in_doubt() ? "**" + runs + "**" : runs) + "\n\n" + summary_legend() +
             "\n\n" + row_of_table(summary_names(), summary_figures(), false));
  file.write(row_of_table(std::vector<std::string>(summary_names().size(), ":---"),
                          std::vector<std::string>(summary_figures().size(), "---:"), false));
  comparison::each_judged(
      store, [](const comparison::JudgedRun&) {},
      [&](const comparison::JudgedCell& cell) {
        const SummaryRow row = summary_row(cell);
        file.write(row_of_table(row.names, row.figures, row.failed > 0));
      });
  file.close();
}

}  // namespace ricochet::exports
