#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/core/problem.h"

namespace ricochet {

/// How a question is shown to a solver: a property of a run, never of the question or its name.
struct Form {
  double width = 0;        ///< smoothing width of the surrogate that is shown; 0: what is judged
  bool penalised = false;  ///< constraints are charged to the objective; see penalty.h

  bool operator==(const Form&) const = default;
};

/// What is asked and judged. Every form of it has the same name, box, start and truth; one best
/// value, which `stated` knows, holds for all.
struct Question {
  Problem stated;             ///< shown just as it is judged
  std::string machine = {};   ///< that it is asked of, e.g. "C1"; empty where of none
  double width = 0;           ///< smoothing width unless another is asked for; where it has any
  double tolerance = 1e-6;    ///< >= 0, regret that still counts as solved
  double penalty_weight = 1;  ///< > 0: the best point stays best where constraints are penalised
  double scan_step = 1e-3;    ///< of an exhaustive scan of the box, where there is one variable
  double cost = 1;            ///< simulations that an evaluation takes, about
  /// What a gradient takes beside the value, in evaluations, about, measured; nothing: n.
  std::optional<std::int64_t> gradient_cost = {};
  /// What is varied from machine to machine, by name, e.g. "restitution".
  std::map<std::string, double> factors = {};

  const std::string& name() const { return stated.name; }

  /// Those it can be shown in: as stated, then smoothed, by its usual width and by these; each
  /// followed by itself penalised.
  std::vector<Form> forms(const std::vector<double>& widths = {}) const;

  /// The problem in this form, of any width. Throws std::invalid_argument for a form that it cannot
  /// be shown in.
  Problem problem(const Form& form) const;

  /// "count" and "surrogate" where it can be smoothed, the width added where it is not the usual
  /// one, else "as-stated"; "penalised-count", "penalised" and so on.
  std::string name_of(const Form& form) const;

  /// The one of forms() that has this name; where it is empty, as judged. Throws InputError, with
  /// what may have been meant, where there is none.
  Form form_named(const std::string& wanted) const;
};

}  // namespace ricochet
