#pragma once

#include <nlopt.h>

#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ricochet/solver.h"
#include "solvers/nlopt/algorithm.h"
#include "solvers/unit_box.h"

namespace ricochet {

/// A search by NLopt in the unit cube, with its callbacks.
///
/// Where the evaluator refuses, or a value ends the search, NLopt is stopped by force, and some of
/// its algorithms then forget the best point: MLSL and AUGLAG that of their inner search. So the
/// search is repeated from the answers that it had, which costs no evaluation, with NLopt's own
/// limit `maxeval`, and the point that NLopt then returns is the returned one.
///
/// What was answered is found by the point where NLopt, once it is at its limit, looks at an
/// earlier point again.
class NloptSearch {
 public:
  /// `seed` is that of NLopt's random numbers.
  NloptSearch(const NloptAlgorithm& algorithm, Evaluator& evaluator, unsigned long seed);

  SolverTermination from(const Vector& start);

 private:
  using Handle = std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)>;

  /// How NLopt ended, and the point in the unit cube that it returned.
  struct Outcome {
    nlopt_result result;
    Vector u;
  };

  static double objective(unsigned n, const double* u, double* gradient, void* self);
  static double largest_inequality(unsigned n, const double* u, double* gradient, void* self);
  static void equalities(unsigned m, double* result, unsigned n, const double* u, double* jacobian,
                         void* self);
  static void inequalities(unsigned m, double* result, unsigned n, const double* u,
                           double* jacobian, void* self);
  Handle made(nlopt_algorithm id) const;
  Outcome optimise(const Vector& start, std::int64_t most_evaluations);
  std::optional<Vector> repeated(const Vector& start);
  void constrain();
  std::optional<Derivatives> answered(const double* point, bool slopes);
  void keep(const double* point, bool slopes, const Derivatives& seen);
  void constraints(Part part, double* result, const double* u, double* jacobian);
  Derivatives look(const double* point, bool slopes, Part part);
  Derivatives no_number() const;
  void end(const char* why);

  const NloptAlgorithm& algorithm_;
  Evaluator& evaluator_;
  unsigned long seed_;
  UnitBox box_;
  Handle nlopt_{nullptr, nlopt_destroy};
  double worst_ = 0;   // objective so far
  std::string ended_;  // empty while the search may go on
  std::exception_ptr thrown_;
  /// The answers of the search, in order: where each begins in `numbers_`, and whether it has
  /// derivatives. Its numbers are the point, the values, and the derivatives.
  struct Place {
    std::size_t first;
    bool slopes;
  };
  std::vector<Place> answers_;
  std::vector<double> numbers_;
  std::int64_t objectives_ = 0;  ///< answered requests of the objective
  std::size_t next_ = 0;         ///< of the answers, when they are repeated
  bool repeating_ = false;
  bool beyond_ = false;  ///< a repetition requested what was not answered
};

}  // namespace ricochet
