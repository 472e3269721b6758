#include "solvers/nlopt/search.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace ricochet {
namespace {

constexpr std::int64_t direct_points = 500'000;   // NLopt's own default
constexpr std::int64_t all_points = 200'000'000;  // ten times as many still fit into an int
constexpr std::size_t most_numbers = 50'000'000;  // of kept answers: 400 MB

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

NloptSearch::NloptSearch(const NloptAlgorithm& algorithm, Evaluator& evaluator, unsigned long seed)
    : algorithm_(algorithm), evaluator_(evaluator), seed_(seed), box_(evaluator) {}

NloptSearch::Outcome NloptSearch::optimise(const Vector& start, std::int64_t most_evaluations) {
  nlopt_ = made(algorithm_.id);
  nlopt_opt nlopt = nlopt_.get();
  nlopt_set_lower_bounds1(nlopt, 0.0);
  nlopt_set_upper_bounds1(nlopt, 1.0);
  nlopt_set_min_objective(nlopt, objective, this);
  constrain();
  nlopt_set_initial_step1(nlopt, algorithm_.initial_step);
  nlopt_set_population(nlopt, static_cast<unsigned>(algorithm_.population));
  if (algorithm_.local) nlopt_set_local_optimizer(nlopt, made(*algorithm_.local).get());
  nlopt_set_maxeval(nlopt, static_cast<int>(most_evaluations));
  nlopt_srand(seed_);  // the state belongs to this thread and is left over from its last run
  Outcome outcome{NLOPT_FAILURE, start};
  double lowest = 0;
  outcome.result = nlopt_optimize(nlopt, outcome.u.data(), &lowest);
  return outcome;
}

/// What NLopt returns with the largest `maxeval` at which it requests no more than was answered;
/// nothing if it requests more at each. Most algorithms request as many as their limit; some look
/// at it only after a line search or a generation, so the largest one is searched.
std::optional<Vector> NloptSearch::repeated(const Vector& start) {
  if (numbers_.size() > most_numbers) return std::nullopt;
  repeating_ = true;
  std::optional<Vector> returned;
  // AGS also counts the points that it finds infeasible, whose objective it does not request.
  std::int64_t kept = 0, exceeded = std::max<std::int64_t>(objectives_, std::ssize(answers_)) + 1;
  for (std::int64_t back = 1; exceeded - kept > 1; back *= 2) {
    const std::int64_t limit =
        returned ? std::midpoint(kept, exceeded) : std::max<std::int64_t>(1, exceeded - back);
    next_ = 0;
    beyond_ = false;
    Outcome outcome = optimise(start, limit);
    (beyond_ ? exceeded : kept) = limit;
    if (!beyond_) returned = std::move(outcome.u);
  }
  return returned;
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

/// Keeps what NLopt is told of a point; separate calls for its parts are one answer.
void NloptSearch::keep(const double* point, bool slopes, const Derivatives& seen) {
  if (numbers_.size() > most_numbers) return;
  const Eigen::Index n = evaluator_.dimension();
  if (!answers_.empty() && answers_.back().slopes >= slopes &&
      std::equal(point, point + n, numbers_.begin() + answers_.back().first)) {
    return;
  }
  answers_.push_back({numbers_.size(), slopes});
  numbers_.insert(numbers_.end(), point, point + n);
  numbers_.push_back(seen.values.objective);
  const Vector& constraints = seen.values.constraints;
  numbers_.insert(numbers_.end(), constraints.begin(), constraints.end());
  if (!slopes) return;
  numbers_.insert(numbers_.end(), seen.gradient.begin(), seen.gradient.end());
  const auto jacobian = seen.jacobian.reshaped();
  numbers_.insert(numbers_.end(), jacobian.begin(), jacobian.end());
}

/// What NLopt was told of a point, in the order of the search, or else the last time; nothing if it
/// was not.
std::optional<Derivatives> NloptSearch::answered(const double* point, bool slopes) {
  const Eigen::Index n = evaluator_.dimension();
  const Eigen::Index m = evaluator_.constraints();
  const auto is_of_point = [&](const Place& place) {
    return place.slopes >= slopes && std::equal(point, point + n, numbers_.data() + place.first);
  };
  if (next_ < answers_.size() && is_of_point(answers_[next_])) ++next_;
  const auto known = std::span(answers_).first(next_);
  const auto place = std::find_if(known.rbegin(), known.rend(), is_of_point);
  if (place == known.rend()) return std::nullopt;
  const double* at = numbers_.data() + place->first + n;
  Derivatives seen{{*at, Eigen::Map<const Vector>(at + 1, m)}, {}, {}};
  if (!place->slopes) return seen;
  seen.gradient = Eigen::Map<const Vector>(at + 1 + m, n);
  seen.jacobian = Eigen::Map<const Matrix>(at + 1 + m + n, m, n);
  return seen;
}

/// Objective and constraints at a point; `slopes` asks for derivatives too.
Derivatives NloptSearch::look(const double* point, bool slopes, Part part) {
  if (repeating_) {
    std::optional<Derivatives> seen = answered(point, slopes);
    if (seen) return *std::move(seen);
    beyond_ = true;
    nlopt_force_stop(nlopt_.get());
    return no_number();
  }
  // No exception may pass through NLopt, which is C.
  try {
    const Vector u = Eigen::Map<const Vector>(point, evaluator_.dimension());
    std::optional<Derivatives> seen;
    if (slopes) {
      seen = box_.derivatives(u, part);
    } else if (auto values = box_.values(u, part)) {
      seen = Derivatives{*std::move(values), {}, {}};
    }
    const bool numbers = seen && finite(*seen);
    if (numbers) worst_ = std::max(worst_, seen->values.objective);
    if (!seen || (!numbers && algorithm_.no_number == NloptAlgorithm::NoNumber::ends_the_search)) {
      end(evaluator_.over() ? stopped_by_evaluator : not_finite);
      return no_number();
    }
    Derivatives told = numbers ? *std::move(seen) : no_number();
    keep(point, slopes, told);
    return told;
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
  auto& search = *static_cast<NloptSearch*>(self);
  const Derivatives seen = search.look(u, gradient, Part::objective);
  if (!search.repeating_ && search.ended_.empty()) ++search.objectives_;
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
  const Vector u = box_.to_unit(start).cwiseMax(0.0).cwiseMin(1.0);
  const bool direct = algorithm_.is_original_direct();
  // NLopt 2.7.1 reads beyond its memory when DIRECT is stopped at its first point, the middle. So
  // that point is evaluated beforehand; the evaluator remembers it.
  if (direct) {
    const Vector middle = Vector::Constant(u.size(), 0.5);
    look(middle.data(), false, Part::nothing);
    if (thrown_) std::rethrow_exception(thrown_);
    if (!ended_.empty()) return {ended_};
  }
  // NLopt's limit lies beyond the budget: the evaluator, which knows what an evaluation costs, ends
  // the search first.
  const std::int64_t left = std::min(evaluator_.remaining(), direct ? direct_points : all_points);
  const Outcome outcome = optimise(u, direct ? left + 1 : 10 * left + 10);
  if (thrown_) std::rethrow_exception(thrown_);
  if (ended_.empty()) return {in_words(outcome.result), box_.from_unit(outcome.u)};
  const std::optional<Vector> returned = repeated(u);
  return {ended_, returned ? std::optional(box_.from_unit(*returned)) : std::nullopt};
}

}  // namespace ricochet
