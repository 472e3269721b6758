#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "problems/family.h"
#include "src/campaign/plan.h"
#include "src/core/solver.h"
#include "src/features/feature.h"
#include "src/store/store.h"

namespace ricochet {

/// What plans choose from.
struct Catalogue {
  std::vector<Family> families;
  std::vector<Solver> solvers;
  /// A solver of the user's own, a library or a program; nothing where the text names none.
  std::function<std::optional<Solver>(const std::string&)> own_solver;
  /// The families of questions asked of a grid of machines, whose best values are not known.
  std::function<std::vector<Family>(const MachineGrid&)> families_of;
  /// A solver of the plan's with options of its own. Throws InputError for what cannot be.
  std::function<Solver(const VariedSolver&)> varied_solver;
  /// A question of one variable with the best value that a search finds, if any.
  std::function<Question(Question)> with_best;
};

/// A cell of a campaign, and what it takes to make its runs.
struct PlannedCell {
  Cell cell;
  std::size_t question;  ///< index into Campaign::questions
  Form form;
  const Feature* feature;
  std::size_t solver;  ///< index into Campaign::solvers
  Budget budget;
  int instances;
  int seeds;
  std::vector<std::size_t> parts;  ///< of the plan, that ask for it
};

/// A plan with all that it takes to carry it out.
class Campaign {
 public:
  /// Throws InputError, naming part and key, for a pattern that nothing fits, and for a part of
  /// which nothing is left to run. Questions whose best value is not known are never chosen.
  Campaign(Plan plan, const Catalogue& catalogue);

  const Plan& plan() const { return plan_; }
  const std::vector<Question>& questions() const { return questions_; }
  const std::vector<Solver>& solvers() const { return solvers_; }
  const std::vector<PlannedCell>& cells() const { return cells_; }

  /// The family that a question is of.
  const std::string& family_of(std::size_t question) const { return families_[question]; }

  /// Null where the plan has no such cell.
  const PlannedCell* find(const Cell& cell) const;

  std::int64_t runs() const;

  /// Simulations that the runs take at most, about.
  double work() const;

  /// What its store is made with; `program` and `made` are the caller's to fill.
  CampaignDescription description() const;

 private:
  std::size_t index_of(const Question& question, const std::string& family);
  std::size_t index_of(const Solver& solver);
  void add_part(std::size_t part, const Catalogue& catalogue);

  Plan plan_;
  std::vector<Question> questions_;
  std::vector<std::string> families_;  ///< of the questions
  std::vector<Solver> solvers_;
  std::vector<PlannedCell> cells_;
  std::map<Cell, std::size_t> places_;  ///< of the cells
  std::map<std::string, std::size_t> question_places_, solver_places_;
  std::map<std::string, std::string> own_texts_;  ///< of the plan, for solvers of the user's own
};

}  // namespace ricochet
