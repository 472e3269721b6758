#include "src/benchmark/export/latex_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "src/benchmark/export/latex_text.h"
#include "src/benchmark/export/output_file.h"

namespace ricochet::exports {
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

}  // namespace ricochet::exports
