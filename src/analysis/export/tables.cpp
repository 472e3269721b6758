#include "src/analysis/export/tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "src/analysis/export/formats.h"
#include "src/analysis/export/output.h"
#include "src/analysis/outcomes.h"
#include "src/analysis/results.h"
#include "src/core/names.h"
#include "src/report/text.h"

namespace ricochet::exports {

/// The text as one line with LaTeX's special characters escaped; needs textcomp and T1 fonts.
std::string latex_text(std::string_view text);

/// The row of a cell in a printed table, not yet escaped for a language.
struct SummaryRow {
  std::vector<std::string> names;    ///< as named in summary_names
  std::vector<std::string> figures;  ///< as named in summary_figures
  int failed = 0;                    ///< runs that ended in an exception
};

std::vector<std::string> summary_names();
std::vector<std::string> summary_figures();

/// One sentence for each figure, for the text below or above the table.
std::string summary_legend();

/// The expected running time is "-" if unknown, because no run solved the problem.
SummaryRow summary_row(const comparison::JudgedCell& cell);

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

namespace {

using comparison::RatedFamily;
using comparison::Rating;

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
family & problems & budget & entry & solved \% & rank & P(best) \\
\midrule
)";

constexpr const char* foot = R"(\bottomrule
\end{tabular}}
\end{table}
)";

/// The rows of the first entries, at most so many; one that solved no run is not among the first.
std::string rows_of(const RatedFamily& family, std::size_t most) {
  std::string place =
      fmt::format("{} & {} & {}", latex_text(family.name), family.problems, family.budget);
  std::string rows;
  std::size_t shown = 0;
  for (const Rating& rating : family.ratings) {
    if (!rating.rank || rating.returned == 0) continue;
    if (shown++ == most) break;
    const auto best = rating.probability_of_being_best;
    rows += fmt::format("{} & {} & {:.0f} & {:.1f} & {} \\\\\n", place,
                        latex_text(comparison::entry(rating.solver, rating.formulation)),
                        100 * rating.returned, *rating.rank,
                        best ? fmt::format("{:.2f}", *best) : "--");
    place = " & &";
  }
  return shown > 0 ? rows : place + " & no run is solved & & & \\\\\n";
}

}  // namespace

void write_latex_summary(const std::vector<RatedFamily>& families,
                         const std::filesystem::path& folder) {
  const std::size_t most = rows_of_a_page / std::max<std::size_t>(1, families.size());
  std::string text = head;
  for (const RatedFamily& family : families) {
    text += rows_of(family, std::max<std::size_t>(1, most));
  }
  write_file(folder / "summary.tex", text + foot);
}

std::string latex_text(std::string_view text) {
  std::string tex;
  for (const char c : one_line(text)) {
    switch (c) {
      case '\\':
        tex += "\\textbackslash{}";
        break;
      case '~':
        tex += "\\textasciitilde{}";
        break;
      case '^':
        tex += "\\textasciicircum{}";
        break;
      case '<':
        tex += "\\textless{}";
        break;
      case '>':
        tex += "\\textgreater{}";
        break;
      case '|':
        tex += "\\textbar{}";
        break;
      case '"':
        tex += "\\textquotedbl{}";
        break;
      case '\'':
        tex += "\\textquotesingle{}";
        break;
      case '`':
        tex += "\\textasciigrave{}";
        break;
      case '-':  // LaTeX would turn two of them into a dash
        tex += tex.ends_with('-') ? "{}-" : "-";
        break;
      case '[':  // after the end of a row LaTeX would read these as part of it
      case '*':
        tex += {'{', c, '}'};
        break;
      case '#':
      case '$':
      case '%':
      case '&':
      case '_':
      case '{':
      case '}':
        tex += '\\';
        [[fallthrough]];
      default:
        tex += c;
    }
  }
  return tex;
}

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

using comparison::Reach;

void write_ratings(const std::vector<RatedFamily>& families, const std::filesystem::path& folder) {
  OutputFile ratings(folder / "ratings.csv");
  OutputFile ecdf(folder / "ecdf.csv");
  OutputFile targets(folder / "targets.csv");
  ratings.write(csv_row({"family", "problems", "budget_per_variable", "solver", "formulation",
                         "problems_taken", "problems_never_solved", "solved_share",
                         "returned_solved_share", "mean_rank", "probability_of_being_best"}));
  ecdf.write(csv_row({"family", "solver", "formulation", "evaluations_per_variable", "share",
                      "share_lower", "share_upper"}));
  targets.write(csv_row({"family", "problem", "target"}));
  for (const RatedFamily& family : families) {
    for (const auto& [problem, gaps] : family.targets) {
      for (const double gap : *gaps) {
        targets.write(csv_row({label_of(family.name), label_of(problem), number(gap)}));
      }
    }
    for (const Rating& rating : family.ratings) {
      ratings.write(csv_row(
          {label_of(family.name), std::to_string(family.problems), std::to_string(family.budget),
           label_of(rating.solver), label_of(rating.formulation), std::to_string(rating.problems),
           std::to_string(rating.never), number(rating.found), number(rating.returned),
           number(rating.rank), number(rating.probability_of_being_best)}));
      for (const Reach& reach : rating.progress) {
        ecdf.write(
            csv_row({label_of(family.name), label_of(rating.solver), label_of(rating.formulation),
                     number(reach.evaluations), number(reach.share), number(reach.interval.lower),
                     number(reach.interval.upper)}));
      }
    }
  }
  ratings.close();
  ecdf.close();
  targets.close();
}

namespace {

/// Adds success rate and expected running time, each with its interval.
void add_to(std::vector<std::string>& row, const comparison::SolvedShare& solved,
            const std::optional<comparison::Estimate>& time) {
  for (const double share : {solved.share, solved.interval.lower, solved.interval.upper}) {
    row.push_back(number(share));
  }
  row.push_back(time ? number(time->value) : "");
  row.push_back(time ? number(time->interval.lower) : "");
  row.push_back(time ? number(time->interval.upper) : "");
}

}  // namespace

RunningTimes::RunningTimes(const std::filesystem::path& file) : file_(file) {
  file_.write(csv_row({"algorithm",
                       "function_id",
                       "problem",
                       "variables",
                       "solver",
                       "formulation",
                       "perturbation",
                       "gradient_price",
                       "budget_per_variable",
                       "runs",
                       "distinct_runs",
                       "failed_runs",
                       "solved_share",
                       "solved_share_lower",
                       "solved_share_upper",
                       "expected_running_time",
                       "expected_running_time_lower",
                       "expected_running_time_upper",
                       "returned_solved_share",
                       "returned_solved_share_lower",
                       "returned_solved_share_upper",
                       "returned_expected_running_time",
                       "returned_expected_running_time_lower",
                       "returned_expected_running_time_upper"}));
}

void RunningTimes::add(const comparison::JudgedCell& judged, Numbering& numbering) {
  const Cell& cell = judged.cell;
  const comparison::Result result = comparison::result_of(judged.outcomes);
  std::vector<std::string> row = {
      numbering.algorithm(cell),       std::to_string(numbering.function_id(cell.problem)),
      label_of(cell.problem),          std::to_string(judged.problem.variables),
      label_of(cell.solver),           label_of(cell.formulation),
      label_of(cell.perturbation),     label_of(cell.gradient_price),
      std::to_string(cell.budget),     std::to_string(result.runs),
      std::to_string(result.distinct), std::to_string(result.failed)};
  add_to(row, result.found, result.running_time);
  add_to(row, result.returned, result.returned_running_time);
  file_.write(csv_row(row));
}

namespace {

std::string count(double value) {
  if (std::isinf(value)) return "inf";
  return value < 1e7 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

std::string percent(double share) {
  return fmt::format("{:.0f}", 100 * share);
}

template <class Text>
std::string interval(const Interval& interval, Text text) {
  return fmt::format("{} to {}", text(interval.lower), text(interval.upper));
}

}  // namespace

std::vector<std::string> summary_names() {
  return {"problem", "solver", "formulation", "perturbation", "price", "budget"};
}

std::vector<std::string> summary_figures() {
  return {"runs", "solved %", "95 % interval", "ERT", "95 % interval", "failed"};
}

std::string summary_legend() {
  return "Budgets are evaluations per variable; price: evaluations charged for a gradient, n: the "
         "number of variables. Solved: share of runs that evaluated a feasible point within the "
         "problem's tolerance of its best known value; identical runs count once; Wilson's "
         "interval. ERT: expected running time, evaluations until solved; unsolved runs count with "
         "all their evaluations. Failed: runs that ended in an exception or were killed.";
}

SummaryRow summary_row(const comparison::JudgedCell& judged) {
  const comparison::Result result = comparison::result_of(judged.outcomes);
  const Cell& cell = judged.cell;
  const auto& time = result.running_time;
  return {{cell.problem, cell.solver, cell.formulation, label(cell.perturbation),
           cell.gradient_price, std::to_string(cell.budget)},
          {std::to_string(result.runs), percent(result.found.share),
           interval(result.found.interval, percent), time ? count(time->value) : "-",
           time ? interval(time->interval, count) : "-", std::to_string(result.failed)},
          result.failed};
}

}  // namespace ricochet::exports
