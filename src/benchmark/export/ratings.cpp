#include "src/benchmark/export/ratings.h"

#include "src/benchmark/export/csv_row.h"
#include "src/benchmark/export/label_of.h"
#include "src/benchmark/export/output_file.h"

namespace ricochet::exports {

using comparison::RatedFamily;
using comparison::Rating;
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

}  // namespace ricochet::exports
