#include "solvers/plateau_search/plateau_search.h"

#include <optional>

#include "solvers/plateau_search/descent.h"
#include "solvers/plateau_search/drift.h"
#include "solvers/plateau_search/sight.h"
#include "solvers/unit_box.h"

namespace ricochet {
namespace {

using drifting::DriftLimits;
using drifting::Seen;
using drifting::Sight;

constexpr int first_points = 5;       // of which a round begins at the best
constexpr double first_step = 0.3;    // of the box
constexpr double second_step = 0.05;  // after a descent
constexpr double return_step = 0.1;   // from the best point
constexpr double returns = 0.5;       // share of the rounds with constraints that begin there
constexpr double widths[] = {0.25, 0.1};

/// Steps without a better point that end a drift, for each variable and one more.
constexpr int patience = 30;
constexpr int patience_with_constraints = 10;
constexpr int patience_before_descent = 5;
constexpr int patience_after_descent = 3;

class PlateauSearch {
 public:
  PlateauSearch(Sight& sight, Random& random)
      : sight_(sight),
        random_(random),
        descends_(sight.problem().differentiate && sight.problem().constraints == 0) {}

  /// The first round begins at the start. False once the run is over.
  bool round(const Vector* start) {
    if (start == nullptr && sight_.problem().constraints > 0 && uniform(random_) < returns) {
      Seen best = sight_.best().value();
      return drift(sight_, best, {return_step, steps(patience_with_constraints)}, random_);
    }
    auto at = first(start);
    if (!at || !drift(sight_, *at, limits(), random_)) return false;
    if (!descends_) return true;
    while (true) {
      const auto lower = below(*at);
      if (!lower) return false;
      const bool gained = better(lower->truth, at->truth);
      if (!better(at->truth, lower->truth)) at = lower;
      if (!gained) return true;
      const DriftLimits again{second_step, steps(patience_after_descent)};
      if (!drift(sight_, *at, again, random_)) return false;
    }
  }

 private:
  std::int64_t steps(int of_patience) const {
    return of_patience * (sight_.problem().dimension() + 1);
  }

  DriftLimits limits() const {
    if (descends_) return {first_step, steps(patience_before_descent)};
    const bool limited = sight_.problem().constraints > 0;
    return {first_step, steps(limited ? patience_with_constraints : patience)};
  }

  std::optional<Seen> first(const Vector* start) {
    std::optional<Seen> best;
    for (int k = 0; k < first_points; ++k) {
      const bool given = k == 0 && start != nullptr;
      const Vector u = given ? sight_.to_unit(*start) : sight_.uniform_point(random_);
      const auto truth = sight_.look(u);
      if (!truth) return std::nullopt;
      if (!best || better(*truth, best->truth)) best = Seen{u, *truth};
    }
    return best;
  }

  /// Where a descent from there leads.
  std::optional<Seen> below(const Seen& at) {
    std::optional<double> width;
    if (sight_.problem().smoothed) width = widths[descents_++ % std::size(widths)];
    Seen end = at;
    const auto lowest = descend(sight_, end.u, width);
    if (!lowest) return std::nullopt;
    if (end.u == at.u) return at;
    const auto truth = width ? sight_.look(end.u) : std::optional(Truth{*lowest, 0});
    if (!truth) return std::nullopt;
    end.truth = *truth;
    return end;
  }

  Sight& sight_;
  Random& random_;
  bool descends_;
  std::size_t descents_ = 0;
};

}  // namespace

Solver plateau_search() {
  Solver solver;
  solver.name = "plateau-search";
  solver.version = "ricochet " RICOCHET_VERSION;
  solver.stochastic = true;
  solver.accepts = [](const Problem& problem) {
    return has_room(problem) && problem.equalities == 0;
  };
  solver.solve = [](Evaluator& evaluator, const Vector& start, Random& random) -> SolverExit {
    Sight sight(evaluator);
    PlateauSearch search(sight, random);
    const Vector* from = &start;
    while (search.round(from)) from = nullptr;
    if (!sight.best()) return {stopped_by_evaluator};
    return {stopped_by_evaluator, sight.from_unit(sight.best()->u)};
  };
  return solver;
}

}  // namespace ricochet
