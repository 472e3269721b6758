#pragma once

#include <nlopt.h>

#include <exception>
#include <memory>
#include <string>

#include "ricochet/solver.h"
#include "solvers/nlopt/algorithm.h"
#include "solvers/unit_box.h"

namespace ricochet {

/// One call of nlopt_optimize in the unit cube, with its callbacks.
class NloptSearch {
 public:
  NloptSearch(const NloptAlgorithm& algorithm, Evaluator& evaluator);

  SolverTermination from(const Vector& start);

 private:
  using Handle = std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)>;

  static double objective(unsigned n, const double* u, double* gradient, void* self);
  static double largest_inequality(unsigned n, const double* u, double* gradient, void* self);
  static void equalities(unsigned m, double* result, unsigned n, const double* u, double* jacobian,
                         void* self);
  static void inequalities(unsigned m, double* result, unsigned n, const double* u,
                           double* jacobian, void* self);
  Handle made(nlopt_algorithm id) const;
  void constrain();
  void constraints(Part part, double* result, const double* u, double* jacobian);
  Derivatives look(const double* point, bool slopes, Part part);
  Derivatives no_number() const;
  void end(const char* why);

  const NloptAlgorithm& algorithm_;
  Evaluator& evaluator_;
  UnitBox box_;
  Handle nlopt_;
  double worst_ = 0;   // objective so far
  std::string ended_;  // empty while the search may go on
  std::exception_ptr thrown_;
};

}  // namespace ricochet
