#include "src/benchmark/export/latex.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "src/benchmark/export/latex_text.h"
#include "src/benchmark/export/output_file.h"
#include "src/benchmark/export/summary_row.h"

namespace ricochet::exports {
namespace {

/// The cells in a row, the last one bold if runs failed.
std::string line(const std::vector<std::string>& names, const std::vector<std::string>& figures,
                 bool failed) {
  std::vector<std::string> cells;
  for (const std::string& name : names) cells.push_back(latex_text(name));
  for (const std::string& figure : figures) {
    cells.push_back(figure == "-" ? "--" : latex_text(figure));
  }
  if (failed) cells.back() = "\\textbf{" + cells.back() + "}";
  return fmt::format("{} \\\\\n", fmt::join(cells, " & "));
}

}  // namespace

void write_latex(const Store& store, const Completeness& completeness,
                 const std::filesystem::path& folder) {
  OutputFile file(folder / "table.tex");
  const std::string header = line(summary_names(), summary_figures(), false);
  file.write(
      "% To be read by \\input. Needs \\usepackage{longtable}, \\usepackage{booktabs} and\n"
      "% \\usepackage{textcomp}, \\usepackage[T1]{fontenc}, and as wide a page.\n"
      "\\begin{longtable}{" +
      std::string(summary_names().size() - 1, 'l') +
      std::string(summary_figures().size() + 1, 'r') + "}\n\\caption{" +
      latex_text(summary_legend() +
                 (completeness.is_in_doubt() ? " " + as_sentence(completeness) : "")) +
      "}\\\\\n\\toprule\n" + header + "\\midrule\n\\endfirsthead\n\\toprule\n" + header +
      "\\midrule\n\\endhead\n\\bottomrule\n\\endfoot\n");
  comparison::each_judged(
      store, [](const comparison::JudgedRun&) {},
      [&](const comparison::JudgedCell& cell) {
        const SummaryRow row = summary_row(cell);
        file.write(line(row.names, row.figures, row.failed > 0));
      });
  file.write("\\end{longtable}\n");
  file.close();
}

}  // namespace ricochet::exports
