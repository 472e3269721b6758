#include "solvers/nlopt.h"

#include <fmt/format.h>
#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <initializer_list>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ricochet/solver.h"
#include "solvers/scaled_box.h"

namespace ricochet {

/// A search by NLopt, with its callbacks.
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

  /// How NLopt ended, and the point that it returned.
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
  Vector sides() const { return box_.upper() - box_.lower(); }
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
  ScaledBox box_;
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

bool NloptAlgorithm::is_original_direct() const {
  return id == NLOPT_GN_ORIG_DIRECT || id == NLOPT_GN_ORIG_DIRECT_L;
}

namespace {

using Constraints = Capabilities::Constraints;
using Order = Capabilities::Order;
using NoNumber = NloptAlgorithm::NoNumber;

constexpr Capabilities bounds_only = {};
constexpr Capabilities inequalities = {.constraints = Constraints::inequalities};
constexpr Capabilities all_constraints = {.constraints = Constraints::all};

constexpr Capabilities with_gradients(Capabilities capabilities) {
  capabilities.derivatives = Order::gradient;
  return capabilities;
}

/// Returns true for a local algorithm whose runs depend on the coordinates. COBYLA, BOBYQA,
/// Nelder-Mead and Sbplx scale them by their first step, MMA and CCSAQ by their first trust region,
/// which are shares of the box; global algorithms scale the box.
bool feels_coordinates(nlopt_algorithm local) {
  return local == NLOPT_LD_SLSQP || local == NLOPT_LD_LBFGS || local == NLOPT_LD_VAR2 ||
         local == NLOPT_LD_TNEWTON_RESTART;
}

/// What they work in; docs/benchmark-method.md has the comparison.
Coordinates coordinates_for(nlopt_algorithm local) {
  return feels_coordinates(local) ? Coordinates::own : Coordinates::unit;
}

/// The global algorithms. DIRECT is the original code where possible: NLopt's other version takes
/// no constraints.
std::vector<NloptAlgorithm> global_ones() {
  return {
      {.name = "direct",
       .id = NLOPT_GN_ORIG_DIRECT,
       .capabilities = inequalities,
       .no_number = NoNumber::is_infinite},
      {.name = "direct-l",
       .id = NLOPT_GN_ORIG_DIRECT_L,
       .capabilities = inequalities,
       .no_number = NoNumber::is_infinite},
      {.name = "crs2", .id = NLOPT_GN_CRS2_LM, .no_number = NoNumber::is_infinite, .draws = true},
      {.name = "isres",
       .id = NLOPT_GN_ISRES,
       .capabilities = all_constraints,
       .no_number = NoNumber::is_infinite,
       .draws = true},
      {.name = "esch", .id = NLOPT_GN_ESCH, .no_number = NoNumber::is_infinite, .draws = true},
      {.name = "ags",
       .id = NLOPT_GN_AGS,
       .capabilities = {.most_variables = 10, .constraints = Constraints::inequalities},
       .no_number = NoNumber::is_the_worst_so_far},
  };
}

/// A local algorithm, started from the points of a Sobol sequence one after the other.
NloptAlgorithm many_starts(const char* name, nlopt_algorithm local,
                           const Capabilities& capabilities) {
  return {.name = name,
          .id = NLOPT_G_MLSL_LDS,
          .local = local,
          .capabilities = capabilities,
          .no_number = NoNumber::is_the_worst_so_far};
}

/// Constraints for a local algorithm that takes none, or no equalities. For problems with
/// constraints only.
NloptAlgorithm augmented_lagrangian(const char* name, nlopt_algorithm local, Order derivatives) {
  return {
      .name = name,
      .id = NLOPT_AUGLAG,
      .local = local,
      .capabilities = {
          .constraints = Constraints::all, .needs_constraints = true, .derivatives = derivatives}};
}

std::vector<NloptAlgorithm> local_ones() {
  constexpr Capabilities smooth = with_gradients(bounds_only);
  return {
      {.name = "cobyla", .id = NLOPT_LN_COBYLA, .capabilities = all_constraints},
      // Steps smaller than a step of the function are not worth their evaluations.
      {.name = "cobyla-tuned",
       .id = NLOPT_LN_COBYLA,
       .capabilities = all_constraints,
       .tolerance = 1e-4},
      {.name = "bobyqa", .id = NLOPT_LN_BOBYQA},
      {.name = "nelder-mead", .id = NLOPT_LN_NELDERMEAD},
      {.name = "sbplx", .id = NLOPT_LN_SBPLX},
      {.name = "slsqp", .id = NLOPT_LD_SLSQP, .capabilities = with_gradients(all_constraints)},
      {.name = "mma", .id = NLOPT_LD_MMA, .capabilities = with_gradients(inequalities)},
      {.name = "ccsaq", .id = NLOPT_LD_CCSAQ, .capabilities = with_gradients(inequalities)},
      {.name = "lbfgs", .id = NLOPT_LD_LBFGS, .capabilities = smooth},
      {.name = "var2", .id = NLOPT_LD_VAR2, .capabilities = smooth},
      // Its preconditioned variants read uninitialised memory, so their runs may differ.
      {.name = "tnewton", .id = NLOPT_LD_TNEWTON_RESTART, .capabilities = smooth},
      augmented_lagrangian("auglag-bobyqa", NLOPT_LN_BOBYQA, Order::value),
      augmented_lagrangian("auglag-sbplx", NLOPT_LN_SBPLX, Order::value),
      augmented_lagrangian("auglag-lbfgs", NLOPT_LD_LBFGS, Order::gradient),
      augmented_lagrangian("auglag-mma", NLOPT_LD_MMA, Order::gradient),
  };
}

}  // namespace

std::vector<NloptAlgorithm> nlopt_algorithms() {
  std::vector<NloptAlgorithm> algorithms = global_ones();
  algorithms.push_back(many_starts("mlsl-bobyqa", NLOPT_LN_BOBYQA, bounds_only));
  algorithms.push_back(many_starts("mlsl-slsqp", NLOPT_LD_SLSQP, with_gradients(bounds_only)));
  algorithms.push_back(many_starts("mlsl-lbfgs", NLOPT_LD_LBFGS, with_gradients(bounds_only)));
  const std::vector<NloptAlgorithm> local = local_ones();
  algorithms.insert(algorithms.end(), local.begin(), local.end());
  for (NloptAlgorithm& algorithm : algorithms) {
    // It interpolates at n + 2 points or more, which is not possible in one dimension.
    const bool bobyqa = algorithm.id == NLOPT_LN_BOBYQA || algorithm.local == NLOPT_LN_BOBYQA;
    if (bobyqa) algorithm.capabilities.least_variables = 2;
    algorithm.coordinates = coordinates_for(algorithm.local.value_or(algorithm.id));
  }
  return algorithms;
}

namespace {

Solver solver_of(const NloptAlgorithm& algorithm) {
  int version[3];
  nlopt_version(&version[0], &version[1], &version[2]);
  Solver solver;
  solver.name = fmt::format("nlopt-{}", algorithm.name);
  const int adapter = algorithm.coordinates == Coordinates::own ? 3 : 2;
  solver.version = fmt::format("NLopt {} (adapter {})", fmt::join(version, "."), adapter);
  solver.stochastic = algorithm.draws;
  solver.capabilities = algorithm.capabilities;
  solver.at_limit = AtLimit::own_point;
  solver.solve = [algorithm](Evaluator& evaluator, const Vector& start, Random& random) {
    return NloptSearch(algorithm, evaluator, random()).from(start);
  };
  return solver;
}

}  // namespace

/// The options that affect this algorithm.
template <class Visit, IsOf<NloptAlgorithm>... A>
void visit_fields(const Visit& visit, A&... a) {
  const NloptAlgorithm& algorithm = (a, ...);
  const auto is_one_of = [&](std::initializer_list<nlopt_algorithm> ids) {
    return std::find(ids.begin(), ids.end(), algorithm.id) != ids.end();
  };
  const bool starts_anew = algorithm.id == NLOPT_G_MLSL_LDS;
  if (starts_anew || is_one_of({NLOPT_GN_CRS2_LM, NLOPT_GN_ISRES, NLOPT_GN_ESCH})) {
    visit(whole_option("population", 1, 1e6, "NLopt's own"), a.population...);
  }
  if (is_one_of({NLOPT_LN_COBYLA, NLOPT_LN_BOBYQA, NLOPT_LN_NELDERMEAD, NLOPT_LN_SBPLX})) {
    visit(real_option("initial_step", 1e-6, 1), a.initial_step...);
  }
  if (is_one_of({NLOPT_LD_LBFGS, NLOPT_LD_VAR2, NLOPT_LD_TNEWTON_PRECOND_RESTART})) {
    visit(whole_option("vectors", 1, 1000), a.vectors...);
  }
  if (feels_coordinates(algorithm.local.value_or(algorithm.id)))
    visit(coordinates_option, a.coordinates...);
  const bool looks_everywhere =
      algorithm.is_original_direct() ||
      is_one_of({NLOPT_GN_CRS2_LM, NLOPT_GN_ISRES, NLOPT_GN_ESCH, NLOPT_GN_AGS});
  if (!looks_everywhere) visit(real_option("tolerance", 1e-15, 0.1), a.tolerance...);
}

std::vector<Solver> nlopt_solvers() {
  std::vector<Solver> solvers;
  for (const NloptAlgorithm& algorithm : nlopt_algorithms()) {
    solvers.push_back(solver_of(algorithm));
  }
  return solvers;
}

std::vector<AdjustableSolver> adjustable_nlopt() {
  std::vector<AdjustableSolver> solvers;
  for (const NloptAlgorithm& algorithm : nlopt_algorithms()) {
    AdjustableSolver solver =
        adjustable(fmt::format("nlopt-{}", algorithm.name), algorithm, solver_of);
    if (!solver.options.empty()) solvers.push_back(std::move(solver));
  }
  return solvers;
}

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
    : algorithm_(algorithm),
      evaluator_(evaluator),
      seed_(seed),
      box_(evaluator, algorithm.coordinates) {}

NloptSearch::Outcome NloptSearch::optimise(const Vector& start, std::int64_t most_evaluations) {
  nlopt_ = made(algorithm_.id);
  nlopt_opt nlopt = nlopt_.get();
  nlopt_set_lower_bounds(nlopt, box_.lower().data());
  nlopt_set_upper_bounds(nlopt, box_.upper().data());
  nlopt_set_min_objective(nlopt, objective, this);
  constrain();
  nlopt_set_initial_step(nlopt, Vector(algorithm_.initial_step * sides()).data());
  nlopt_set_population(nlopt, static_cast<unsigned>(algorithm_.population.value_or(0)));
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
  nlopt_set_xtol_abs(nlopt.get(), Vector(algorithm_.tolerance * sides()).data());
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
  const Vector u = box_.to_scaled(start);
  const bool direct = algorithm_.is_original_direct();
  // NLopt 2.7.1 reads beyond its memory when DIRECT is stopped at its first point, the middle. So
  // that point is evaluated beforehand; the evaluator remembers it.
  if (direct) {
    const Vector middle = (box_.lower() + box_.upper()) / 2;
    look(middle.data(), false, Part::nothing);
    if (thrown_) std::rethrow_exception(thrown_);
    if (!ended_.empty()) return {ended_};
  }
  // NLopt's limit lies beyond the budget: the evaluator, which knows what an evaluation costs, ends
  // the search first.
  const std::int64_t left = std::min(evaluator_.remaining(), direct ? direct_points : all_points);
  const Outcome outcome = optimise(u, direct ? left + 1 : 10 * left + 10);
  if (thrown_) std::rethrow_exception(thrown_);
  if (ended_.empty()) return {in_words(outcome.result), box_.from_scaled(outcome.u)};
  const std::optional<Vector> returned = repeated(u);
  return {ended_, returned ? std::optional(box_.from_scaled(*returned)) : std::nullopt};
}

}  // namespace ricochet
