#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/problem.h"
#include "ricochet/solver.h"
#include "src/core/instance.h"
#include "src/experiment/perturbations.h"
#include "src/experiment/plan.h"
#include "src/experiment/store.h"

namespace ricochet {

/// The problems, solvers and makers of them that plans choose from.
struct Catalogue {
  std::vector<Family> families;
  std::vector<Solver> solvers;
  /// A user's solver, a library or a program; nothing if the text names none.
  std::function<std::optional<Solver>(const std::string&)> own_solver;
  /// What may vary from machine to machine of a grid: by key, the texts that it allows; numbers >=
  /// 0 if there are none.
  std::map<std::string, std::vector<std::string>> grid_keys;
  /// The problems for a grid of machines, whose keys and levels are allowed. Throws InputError if
  /// there is no machine to vary, or a machine is invalid. A scene of the plan is in the grid.
  std::function<std::vector<SearchedProblem>(const MachineGrid&)> grid_problems;
  /// The problem for a machine drawn around its own one; nothing if it has no machine.
  std::function<std::optional<SearchedProblem>(const Problem&, int number)> drawn_problem;
  /// The plan's solver with its options. Throws InputError if it cannot be made.
  std::function<Solver(const VariedSolver&)> varied_solver;
};

/// The solvers that the texts choose: those of the catalogue by patterns, but one that runs others
/// by its name alone, then a user's own. `own_texts` receives the text of each of these, by its
/// name. Throws InputError, which begins with `place`, for a pattern without a match and for a name
/// that two solvers have.
std::vector<Solver> solvers_of(const std::vector<std::string>& texts, const Catalogue& catalogue,
                               std::map<std::string, std::string>& own_texts,
                               const std::string& place);

/// Results of searches, by problem name.
using AllFindings = std::map<std::string, Findings>;

/// A cell of a campaign, with all data for making its runs.
struct PlannedCell {
  Cell cell;
  std::size_t problem;  ///< index into Campaign::problems
  Formulation formulation;
  const Perturbation* perturbation;  ///< null if the optimum is relocated
  std::size_t solver;                ///< index into Campaign::solvers
  Budget budget;
  int instances;
  int seeds;
  std::vector<std::size_t> parts;  ///< parts of the plan that contain this cell
  /// The prices of a gradient, as the plan names them, at which its runs are what they are.
  std::vector<std::string> gradient_prices;

  bool is_at_price(const std::string& price) const {
    return std::ranges::find(gradient_prices, price) != gradient_prices.end();
  }
};

/// A plan with all data for carrying it out.
class Campaign {
 public:
  /// Throws InputError, naming part and key, for a pattern without a match, for a key or level that
  /// a grid does not allow, for a part without runs, and for more cells, runs or machines than fit
  /// into memory. Leaves out problems whose best value is neither known nor searched for, and those
  /// whose search has no result in `found`.
  Campaign(Plan plan, const Catalogue& catalogue, const AllFindings& found = {});

  /// Problems that are missing in `found`. Until they are searched, the campaign can only count its
  /// runs, not make them.
  const std::map<std::string, SearchedProblem>& to_search() const { return to_search_; }

  const Plan& plan() const { return plan_; }
  const std::vector<Problem>& problems() const { return problems_; }
  const std::vector<Solver>& solvers() const { return solvers_; }
  const std::vector<PlannedCell>& cells() const { return cells_; }

  /// The family of a problem.
  const std::string& family_of(std::size_t problem) const { return families_[problem]; }

  /// The plan's texts for the user's solvers, by name.
  const std::map<std::string, std::string>& own_texts() const { return own_texts_; }

  /// Null if the plan has no such cell.
  const PlannedCell* find(const Cell& cell) const;

  /// Whether the plan has this run.
  bool has(const RunKey& key) const;

  std::int64_t runs() const;

  /// Upper estimate of the number of simulations of all runs.
  double work() const;

  /// The description for its store; the caller fills in `program` and `made`.
  CampaignDescription description() const;

 private:
  struct Chosen {
    Problem problem;
    std::string family;
  };
  std::size_t index_of(const Problem& problem, const std::string& family);
  std::size_t index_of(const Solver& solver);
  std::vector<Chosen> problems_of(const PlanPart& part, const Catalogue& catalogue,
                                  const std::string& place);
  void add_searched(std::vector<Chosen>& chosen, const SearchedProblem& problem);
  void add_part(std::size_t part, const Catalogue& catalogue);

  Plan plan_;
  AllFindings found_;
  std::map<std::string, SearchedProblem> to_search_;
  std::vector<Problem> problems_;
  std::vector<std::string> families_;  ///< by problem
  std::vector<Solver> solvers_;
  std::vector<PlannedCell> cells_;
  std::map<Cell, std::size_t> places_;  ///< indices of the cells
  std::map<std::string, std::size_t> problem_places_, solver_places_;
  std::map<std::string, std::string> own_texts_;
};

/// The place of the best point of a relocated-optimum variant in its box, the same in every
/// coordinate.
enum class OptimumPlace { lower_end, middle, upper_end };

/// The perturbation names of the variants' cells, in the order of the places:
/// "optimum-at-lower-end", "optimum-in-middle", "optimum-at-upper-end".
const std::vector<std::string>& names_of_places();

/// The place named by the perturbation; nothing for another perturbation.
std::optional<OptimumPlace> place_named(const std::string& perturbation);

/// Returns true if the best point is known and in no coordinate at an end of the box.
bool can_be_relocated(const Problem& problem);

/// The same problem in the largest part of its box in which the best point has this place, with
/// start number `number` of those drawn uniformly. A solver whose success rate differs between the
/// variants prefers the ends or the middle of a box.
Problem relocated(Problem problem, OptimumPlace place, int number);

}  // namespace ricochet
