#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/contest/stored_contest.h"
#include "src/report/json.h"
#include "src/studies/contest/reported_part.h"

namespace ricochet::studies::contest {

using namespace ricochet::contest;

/// A solver in the form in which it does best on the questions of a field: the one in which it
/// takes most of them, of these the one with the largest share solved, then the fewest evaluations.
struct Entrant {
  std::string solver, form;
  std::vector<const StoredStanding*> standings;  ///< one a question, in the field's order
};

/// Solvers that can be compared: the questions of one family that a part of the plan asks with one
/// budget, undisturbed, with a gradient at the price of n evaluations.
struct Field {
  std::string family;  ///< as the report calls it
  std::size_t part = 0;
  std::int64_t budget = 0;  ///< evaluations for each variable
  bool largest = false;     ///< no question of it has a larger budget anywhere
  std::vector<std::size_t> questions;
  std::vector<Entrant> entrants;  ///< that take all of the questions, by name
  std::vector<Entrant> partial;   ///< that take some of them only, by name

  /// Whether its entrants are compared with each other: with the largest budget, several of them on
  /// several questions.
  bool compared() const { return largest && entrants.size() > 1 && questions.size() > 1; }
};

/// The fields of a campaign, by part, family and budget. The standings outlive them.
std::vector<Field> fields_of(const Campaign& campaign, const std::vector<StoredStanding>& standings,
                             const std::vector<ReportedPart>& parts);

/// The fields of the largest budgets of which at least half of all solvers take all, as one, whose
/// family is "all" and whose budget is 0. Of fewer than two fields none: no questions.
Field joint_field(const Campaign& campaign, const std::vector<Field>& fields);

/// What `tell` says of each field whose entrants are compared.
template <class Tell>
report::Json of_compared(const std::vector<Field>& fields, const Tell& tell) {
  report::Json all = report::Json::array();
  for (const Field& field : fields) {
    if (field.compared()) all.push_back(tell(field));
  }
  return all;
}

/// Evaluations that a run spent until it solved the question, or in all.
double evaluations_of(const Outcome& outcome);

/// The same in seconds of processor time.
double seconds_of(const Outcome& outcome);

/// What the runs of one entrant on one question come to, each weighing the same.
struct OnQuestion {
  double evaluations;  ///< mean for each variable, of a run that asked for none 1
  double seconds;      ///< mean
  double share;        ///< solved
  double regret;       ///< median, infinite where most found nothing feasible
};
OnQuestion on_question(const Campaign& campaign, const StoredStanding& standing);

/// Geometric mean of costs that are >= 0; those below 1e-6 count as that.
double mean_cost(const std::vector<double>& costs);

}  // namespace ricochet::studies::contest
