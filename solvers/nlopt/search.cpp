#include "solvers/nlopt/search.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace ricochet {
namespace {

constexpr std::int64_t direct_points = 500'000;   // NLopt's own default
constexpr std::int64_t all_points = 200'000'000;  // ten times as many still fit into an int

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

std::string in_words(nlopt_result result) {
  switch (result) {
    case NLOPT_SUCCESS:
      return "success";
    case NLOPT_STOPVAL_REACHED:
      return "stop value reached";
    case NLOPT_FTOL_REACHED:
      return "ftol reached";
    case NLOPT_XTOL_REACHED:
      return "xtol reached";
    case NLOPT_MAXEVAL_REACHED:
      return "maxeval reached";
    case NLOPT_MAXTIME_REACHED:
      return "maxtime reached";
    case NLOPT_INVALID_ARGS:
      return "invalid arguments";
    case NLOPT_OUT_OF_MEMORY:
      return "out of memory";
    case NLOPT_ROUNDOFF_LIMITED:
      return "limited by rounding";
    default:
      return "failure";
  }
}

}  // namespace

NloptSearch::NloptSearch(const NloptAlgorithm& algorithm, Evaluator& evaluator)
    : algorithm_(algorithm), evaluator_(evaluator), box_(evaluator), nlopt_(made(algorithm.id)) {
  nlopt_opt nlopt = nlopt_.get();
  nlopt_set_lower_bounds1(nlopt, 0.0);
  nlopt_set_upper_bounds1(nlopt, 1.0);
  nlopt_set_min_objective(nlopt, objective, this);
  constrain();
  nlopt_set_initial_step1(nlopt, algorithm.initial_step);
  nlopt_set_population(nlopt, static_cast<unsigned>(algorithm.population));
  if (algorithm.local) nlopt_set_local_optimizer(nlopt, made(*algorithm.local).get());
  // NLopt's limit lies beyond the budget: the evaluator ends the search first.
  const bool direct = algorithm.is_original_direct();
  const std::int64_t left = std::min(evaluator.remaining(), direct ? direct_points : all_points);
  nlopt_set_maxeval(nlopt, static_cast<int>(direct ? left + 1 : 10 * left + 10));
}

NloptSearch::Handle NloptSearch::made(nlopt_algorithm id) const {
  const auto n = static_cast<unsigned>(evaluator_.dimension());
  Handle nlopt(nlopt_create(id, n), nlopt_destroy);
  nlopt_set_xtol_abs1(nlopt.get(), algorithm_.tolerance);
  nlopt_set_vector_storage(nlopt.get(), static_cast<unsigned>(algorithm_.vectors));
  return nlopt;
}

void NloptSearch::constrain() {
  nlopt_opt nlopt = nlopt_.get();
  const auto m = static_cast<unsigned>(evaluator_.equalities());
  const auto others = static_cast<unsigned>(evaluator_.constraints()) - m;
  const std::vector<double> tolerances(m + others, constraint_tolerance);
  if (m > 0) nlopt_add_equality_mconstraint(nlopt, m, equalities, this, tolerances.data());
  if (others == 0) return;
  if (algorithm_.id == NLOPT_GN_AGS) {  // it takes them one by one, at most ten
    nlopt_add_inequality_constraint(nlopt, largest_inequality, this, constraint_tolerance);
  } else {
    nlopt_add_inequality_mconstraint(nlopt, others, inequalities, this, tolerances.data());
  }
}

void NloptSearch::end(const char* why) {
  if (ended_.empty()) ended_ = why;
  nlopt_force_stop(nlopt_.get());
}

/// Objective and constraints at a point; `slopes` asks for derivatives too.
Derivatives NloptSearch::look(const double* point, bool slopes, Part part) {
  // No exception may pass through NLopt, which is C.
  try {
    const Vector u = Eigen::Map<const Vector>(point, evaluator_.dimension());
    std::optional<Derivatives> seen;
    if (slopes) {
      seen = box_.derivatives(u, part);
    } else if (auto values = box_.values(u, part)) {
      seen = Derivatives{*std::move(values), {}, {}};
    }
    if (seen && finite(*seen)) {
      worst_ = std::max(worst_, seen->values.objective);
      return *std::move(seen);
    }
    if (!seen || algorithm_.no_number == NloptAlgorithm::NoNumber::ends_the_search) {
      end(evaluator_.over() ? stopped_by_evaluator : not_finite);
    }
  } catch (...) {
    thrown_ = std::current_exception();
    end("an exception");
  }
  return no_number();
}

/// What NLopt gets if a value is not finite or the run is over.
Derivatives NloptSearch::no_number() const {
  const Eigen::Index n = evaluator_.dimension();
  const Eigen::Index m = evaluator_.constraints();
  const bool mild = algorithm_.no_number == NloptAlgorithm::NoNumber::is_the_worst_so_far;
  const Values values{mild ? worst_ : HUGE_VAL, Vector::Constant(m, mild ? 1 : HUGE_VAL)};
  return {values, Vector::Zero(n), Matrix::Zero(m, n)};
}

double NloptSearch::objective(unsigned n, const double* u, double* gradient, void* self) {
  const Derivatives seen = static_cast<NloptSearch*>(self)->look(u, gradient, Part::objective);
  if (gradient) Eigen::Map<Vector>(gradient, n) = seen.gradient;
  return seen.values.objective;
}

double NloptSearch::largest_inequality(unsigned, const double* u, double*, void* self) {
  const Derivatives seen = static_cast<NloptSearch*>(self)->look(u, false, Part::inequalities);
  return seen.values.constraints.maxCoeff();
}

void NloptSearch::equalities(unsigned, double* result, unsigned, const double* u, double* jacobian,
                             void* self) {
  static_cast<NloptSearch*>(self)->constraints(Part::equalities, result, u, jacobian);
}

void NloptSearch::inequalities(unsigned, double* result, unsigned, const double* u,
                               double* jacobian, void* self) {
  static_cast<NloptSearch*>(self)->constraints(Part::inequalities, result, u, jacobian);
}

/// Equalities or inequalities, as chosen by `part`.
void NloptSearch::constraints(Part part, double* result, const double* u, double* jacobian) {
  const Eigen::Index m = evaluator_.equalities();
  const Eigen::Index first = part == Part::equalities ? 0 : m;
  const Eigen::Index end = part == Part::equalities ? m : evaluator_.constraints();
  const Eigen::Index count = end - first;
  const Derivatives seen = look(u, jacobian, part);
  Eigen::Map<Vector>(result, count) = seen.values.constraints.segment(first, count);
  if (jacobian) {
    Eigen::Map<RowMajor>(jacobian, count, evaluator_.dimension()) =
        seen.jacobian.middleRows(first, count);
  }
}

SolverTermination NloptSearch::from(const Vector& start) {
  Vector u = box_.to_unit(start).cwiseMax(0.0).cwiseMin(1.0);
  // NLopt 2.7.1 reads beyond its memory when DIRECT is stopped at its first point, the middle. So
  // that point is evaluated beforehand; the evaluator remembers it.
  if (algorithm_.is_original_direct()) {
    const Vector middle = Vector::Constant(u.size(), 0.5);
    look(middle.data(), false, Part::nothing);
    if (thrown_) std::rethrow_exception(thrown_);
    if (!ended_.empty()) return {ended_};
  }
  double lowest = 0;
  const nlopt_result result = nlopt_optimize(nlopt_.get(), u.data(), &lowest);
  if (thrown_) std::rethrow_exception(thrown_);
  return {ended_.empty() ? in_words(result) : ended_, box_.from_unit(u)};
}

}  // namespace ricochet
