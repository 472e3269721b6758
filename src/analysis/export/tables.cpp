#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "src/analysis/export/formats.h"
#include "src/analysis/export/output.h"
#include "src/analysis/outcomes.h"
#include "src/analysis/results.h"
#include "src/core/names.h"
#include "src/report/table.h"
#include "src/report/text.h"

namespace ricochet::exports {

namespace {

using comparison::RatedFamily;
using comparison::Rating;

constexpr std::size_t texts_of_a_cell = 6;  // columns of names, before those of numbers

/// Of a table with a row for each problem and entry.
const std::vector<Column> columns_of_cells = {{"problem"},
                                              {"solver"},
                                              {"formulation"},
                                              {"perturbation"},
                                              {"price"},
                                              {"budget"},
                                              {"runs"},
                                              {"solved", "solved %", ".0%"},
                                              {"solved_interval", "95 % interval"},
                                              {"running_time", "ERT", ".0f"},
                                              {"running_time_interval", "95 % interval"},
                                              {"failed"}};

constexpr const char* legend =
    "Budgets are evaluations per variable; price: evaluations charged for a gradient, n: the "
    "number of variables. Solved: share of runs that evaluated a feasible point within the "
    "problem's tolerance of its best known value; identical runs count once; Wilson's "
    "interval. ERT: expected running time, evaluations until solved; unsolved runs count with "
    "all their evaluations. Failed: runs that ended in an exception or were killed.";

std::string text_of(const Interval& interval, double unit = 1) {
  return fmt::format("{:.0f} to {:.0f}", interval.lower / unit, interval.upper / unit);
}

/// Writes that table, and at its end `foot`.
void write_cells(const Store& store, const std::filesystem::path& path, TableFile::Writer writer,
                 const char* foot) {
  TableFile file(path, columns_of_cells, std::move(writer));
  comparison::each_judged(
      store, [](const comparison::JudgedRun&) {},
      [&](const comparison::JudgedCell& judged) {
        const comparison::Result result = comparison::result_of(judged.outcomes);
        const Cell& cell = judged.cell;
        const auto& time = result.running_time;
        file.add(cell.problem, cell.solver, cell.formulation, label(cell.perturbation),
                 cell.gradient_price, cell.budget, result.runs, result.found.share,
                 text_of(result.found.interval, 0.01), time ? Value(time->value) : Value(),
                 time ? text_of(time->interval) : "", result.failed);
      });
  file.close(foot);
}

}  // namespace

void write_latex(const Store& store, const Completeness& completeness,
                 const std::filesystem::path& folder) {
  const std::string doubt = completeness.is_in_doubt() ? " " + as_sentence(completeness) : "";
  const auto writer = [&](const Table& table, Lines lines) {
    std::string text = latex_of(table, lines);
    if (lines != Lines::head) return text;
    return "% To be read by \\input. Needs \\usepackage{longtable}, \\usepackage{booktabs} and\n"
           "% \\usepackage{textcomp}, \\usepackage[T1]{fontenc}, and as wide a page.\n"
           "\\begin{longtable}{" +
           std::string(texts_of_a_cell - 1, 'l') +
           std::string(columns_of_cells.size() - texts_of_a_cell + 1, 'r') + "}\n\\caption{" +
           escape_latex(legend + doubt) + "}\\\\\n\\toprule\n" + text +
           "\\midrule\n\\endfirsthead\n\\toprule\n" + text +
           "\\midrule\n\\endhead\n\\bottomrule\n\\endfoot\n";
  };
  write_cells(store, folder / "table.tex", writer, "\\end{longtable}\n");
}

namespace {

constexpr std::size_t rows_of_a_page = 45;

constexpr const char* head =
    R"(% To be read by \input. Needs \usepackage{booktabs}, \usepackage{graphicx},
% \usepackage{textcomp} and \usepackage[T1]{fontenc}.
\begin{table}
\centering
\footnotesize
\caption{The first entries of each family, with its number of problems and its largest budget in
evaluations per variable. Solved: mean success rate by the returned points. Rank: mean over problems and
instances. P(best): probability of the least mean rank on problems like these; none for one problem.}
\resizebox{\ifdim\width>\linewidth\linewidth\else\width\fi}{!}{%
\begin{tabular}{lrrlrrr}
\toprule
)";

constexpr const char* foot = R"(\bottomrule
\end{tabular}}
\end{table}
)";

/// Adds the first entries, at most so many; one that solved no run is not among the first.
void add_first(Table& table, const RatedFamily& family, std::size_t most) {
  std::size_t shown = 0;
  const auto add = [&](const std::string& entry, const auto&... numbers) {
    const bool first = shown++ == 0;
    table.add(first ? family.name : "", first ? value_of(family.problems) : Value(),
              first ? value_of(family.budget) : Value(), entry, numbers...);
  };
  for (const Rating& rating : family.ratings) {
    if (!rating.rank || rating.returned == 0) continue;
    if (shown == most) break;
    add(comparison::entry(rating.solver, rating.formulation), rating.returned, rating.rank,
        rating.probability_of_being_best);
  }
  if (shown == 0) add("no run is solved", Value(), Value(), Value());
}

}  // namespace

void write_latex_summary(const std::vector<RatedFamily>& families,
                         const std::filesystem::path& folder) {
  const std::size_t most = rows_of_a_page / std::max<std::size_t>(1, families.size());
  Table table{"summary",
              {{"family"},
               {"problems"},
               {"budget"},
               {"entry"},
               {"solved", "solved %", ".0%"},
               {"rank", "", ".1f"},
               {"best", "P(best)", ".2f"}}};
  for (const RatedFamily& family : families) {
    add_first(table, family, std::max<std::size_t>(1, most));
  }
  write_file(folder / "summary.tex", head + latex_of(table, Lines::head) + "\\midrule\n" +
                                         latex_of(table, Lines::rows) + foot);
}

void write_markdown(const Store& store, const Completeness& completeness,
                    const std::filesystem::path& folder) {
  const std::string runs = report::escape_markdown(as_sentence(completeness));
  const std::string doubt = completeness.is_in_doubt() ? "**" + runs + "**" : runs;
  const auto writer = [&](const Table& table, Lines lines) {
    const std::string text = markdown_of(table, SIZE_MAX, lines);
    return lines == Lines::head ? doubt + "\n\n" + legend + "\n\n" + text : text;
  };
  write_cells(store, folder / "table.md", writer, "");
}

void write_ratings(const std::vector<RatedFamily>& families, const std::filesystem::path& folder) {
  TableFile ratings(folder / "ratings.csv",
                    columns_named("family,problems,budget_per_variable,solver,formulation,"
                                  "problems_taken,problems_never_solved,solved_share,"
                                  "returned_solved_share,mean_rank,probability_of_being_best"));
  TableFile ecdf(folder / "ecdf.csv",
                 columns_named("family,solver,formulation,evaluations_per_variable,share,"
                               "share_lower,share_upper"));
  TableFile targets(folder / "targets.csv", columns_named("family,problem,target"));
  for (const RatedFamily& family : families) {
    for (const auto& [problem, gaps] : family.targets) {
      for (const double gap : *gaps) targets.add(family.name, problem, gap);
    }
    for (const Rating& rating : family.ratings) {
      ratings.add(family.name, family.problems, family.budget, rating.solver, rating.formulation,
                  rating.problems, rating.never, rating.found, rating.returned, rating.rank,
                  rating.probability_of_being_best);
      for (const auto& [evaluations, share, interval] : rating.progress) {
        ecdf.add(family.name, rating.solver, rating.formulation, evaluations, share, interval.lower,
                 interval.upper);
      }
    }
  }
  for (TableFile* file : {&ratings, &ecdf, &targets}) file->close();
}

RunningTimes::RunningTimes(const std::filesystem::path& file)
    : file_(file, columns_named("algorithm,function_id,problem,variables,solver,formulation,"
                                "perturbation,gradient_price,budget_per_variable,runs,"
                                "distinct_runs,failed_runs,solved_share,solved_share_lower,"
                                "solved_share_upper,expected_running_time,"
                                "expected_running_time_lower,expected_running_time_upper,"
                                "returned_solved_share,returned_solved_share_lower,"
                                "returned_solved_share_upper,returned_expected_running_time,"
                                "returned_expected_running_time_lower,"
                                "returned_expected_running_time_upper")) {}

void RunningTimes::add(const comparison::JudgedCell& judged, Numbering& numbering) {
  const Cell& cell = judged.cell;
  const comparison::Result result = comparison::result_of(judged.outcomes);
  std::vector<Value> row = {numbering.algorithm(cell),
                            cell_of(numbering.function_id(cell.problem)),
                            cell.problem,
                            judged.problem.variables,
                            cell.solver,
                            cell.formulation,
                            cell.perturbation,
                            cell.gradient_price,
                            cell.budget,
                            cell_of(result.runs),
                            cell_of(result.distinct),
                            cell_of(result.failed)};
  const auto add_cells = [&](const comparison::SolvedShare& solved,
                             const std::optional<comparison::Estimate>& time) {
    for (const Value& value :
         {Value(solved.share), Value(solved.interval.lower), Value(solved.interval.upper)}) {
      row.push_back(value);
    }
    row.push_back(time ? Value(time->value) : Value());
    row.push_back(time ? Value(time->interval.lower) : Value());
    row.push_back(time ? Value(time->interval.upper) : Value());
  };
  add_cells(result.found, result.running_time);
  add_cells(result.returned, result.returned_running_time);
  file_.add_row(std::move(row));
}

}  // namespace ricochet::exports
