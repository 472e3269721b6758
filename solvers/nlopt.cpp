#include "solvers/nlopt.h"

#include <fmt/format.h>
#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "solvers/unit_box.h"

namespace ricochet {
namespace {

constexpr double initial_step = 0.25;    // of the box; NLopt's own default, without its exceptions
constexpr double step_tolerance = 1e-8;  // of the box
constexpr unsigned lbfgs_memory = 10;    // pairs kept; NLopt's default allocates 20 MB
constexpr std::int64_t direct_points = 500'000;   // NLopt's own default
constexpr std::int64_t all_points = 200'000'000;  // ten times as many are still an int

enum class Reach { local, global };
enum class Constraints { no, inequalities, all };
enum class Draws { no, yes };

struct Algorithm {
  const char* name;
  nlopt_algorithm id;
  Reach reach;
  Constraints constraints;
  Draws draws;
  Eigen::Index least_dimension;
  double tolerance = step_tolerance;
};

// DIRECT is the original code: the other one in NLopt takes no constraints.
// BOBYQA interpolates at n + 2 points at least, more than it can place in one dimension.
constexpr Algorithm without_derivatives[] = {
    {"direct-l", NLOPT_GN_ORIG_DIRECT_L, Reach::global, Constraints::inequalities, Draws::no, 1},
    {"crs2", NLOPT_GN_CRS2_LM, Reach::global, Constraints::no, Draws::yes, 1},
    {"isres", NLOPT_GN_ISRES, Reach::global, Constraints::all, Draws::yes, 1},
    {"esch", NLOPT_GN_ESCH, Reach::global, Constraints::no, Draws::yes, 1},
    {"cobyla", NLOPT_LN_COBYLA, Reach::local, Constraints::all, Draws::no, 1},
    // What a step smaller than a step of the function can find is not worth its evaluations.
    {"cobyla-tuned", NLOPT_LN_COBYLA, Reach::local, Constraints::all, Draws::no, 1, 1e-4},
    {"bobyqa", NLOPT_LN_BOBYQA, Reach::local, Constraints::no, Draws::no, 2},
    {"nelder-mead", NLOPT_LN_NELDERMEAD, Reach::local, Constraints::no, Draws::no, 1},
    {"sbplx", NLOPT_LN_SBPLX, Reach::local, Constraints::no, Draws::no, 1},
};
constexpr Algorithm with_derivatives[] = {
    {"slsqp", NLOPT_LD_SLSQP, Reach::local, Constraints::all, Draws::no, 1},
    {"mma", NLOPT_LD_MMA, Reach::local, Constraints::inequalities, Draws::no, 1},
    {"lbfgs", NLOPT_LD_LBFGS, Reach::local, Constraints::no, Draws::no, 1},
};

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// One call of nlopt_optimize, seen from inside its callbacks.
class Search {
 public:
  Search(const Algorithm& algorithm, Evaluator& evaluator);

  SolverExit from(const Vector& start);

 private:
  static double objective(unsigned n, const double* u, double* gradient, void* self);
  static void equalities(unsigned m, double* result, unsigned n, const double* u, double* jacobian,
                         void* self);
  static void inequalities(unsigned m, double* result, unsigned n, const double* u,
                           double* jacobian, void* self);
  void constraints(Part part, double* result, const double* u, double* jacobian);
  std::optional<Derivatives> look(const double* point, bool slopes, Part part);
  void end(const char* why);

  const Algorithm& algorithm_;
  Evaluator& evaluator_;
  UnitBox box_;
  std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> nlopt_;
  std::string ended_;  // empty while the search may go on
  std::exception_ptr thrown_;
};

Search::Search(const Algorithm& algorithm, Evaluator& evaluator)
    : algorithm_(algorithm),
      evaluator_(evaluator),
      box_(evaluator),
      nlopt_(nlopt_create(algorithm.id, static_cast<unsigned>(evaluator.problem().dimension())),
             nlopt_destroy) {
  nlopt_opt nlopt = nlopt_.get();
  nlopt_set_lower_bounds1(nlopt, 0.0);
  nlopt_set_upper_bounds1(nlopt, 1.0);
  nlopt_set_min_objective(nlopt, objective, this);
  const auto m = static_cast<unsigned>(evaluator.problem().equalities);
  const auto others = static_cast<unsigned>(evaluator.problem().constraints) - m;
  if (m > 0) {
    const std::vector<double> tolerances(m, equality_tolerance);
    nlopt_add_equality_mconstraint(nlopt, m, equalities, this, tolerances.data());
  }
  if (others > 0) nlopt_add_inequality_mconstraint(nlopt, others, inequalities, this, nullptr);
  nlopt_set_initial_step1(nlopt, initial_step);
  nlopt_set_xtol_abs1(nlopt, algorithm.tolerance);
  if (algorithm.id == NLOPT_LD_LBFGS) nlopt_set_vector_storage(nlopt, lbfgs_memory);
  // The evaluator ends the search. DIRECT sets aside memory for as many points at once.
  const bool direct = algorithm.id == NLOPT_GN_ORIG_DIRECT_L;
  const std::int64_t left = std::min(evaluator.remaining(), direct ? direct_points : all_points);
  nlopt_set_maxeval(nlopt, static_cast<int>(direct ? left + 1 : 10 * left + 10));
}

void Search::end(const char* why) {
  if (ended_.empty()) ended_ = why;
  nlopt_force_stop(nlopt_.get());
}

/// What is to be seen at a point; an infinite objective and constraints where the problem has no
/// number. Nothing when the search is to end. `slopes` asks for derivatives too.
std::optional<Derivatives> Search::look(const double* point, bool slopes, Part part) {
  // No exception may cross NLopt, which is C.
  try {
    const Vector u = Eigen::Map<const Vector>(point, evaluator_.problem().dimension());
    std::optional<Derivatives> seen;
    if (slopes) {
      seen = box_.derivatives(u, part);
    } else if (auto values = box_.values(u, part)) {
      seen = Derivatives{*std::move(values), {}, {}};
    }
    if (seen && finite(*seen)) return seen;
    if (seen && algorithm_.reach == Reach::global) {
      seen->values.objective = HUGE_VAL;
      seen->values.constraints.setConstant(HUGE_VAL);
      return seen;
    }
    end(evaluator_.over() ? stopped_by_evaluator : not_finite);
  } catch (...) {
    thrown_ = std::current_exception();
    end("an exception");
  }
  return std::nullopt;
}

double Search::objective(unsigned n, const double* u, double* gradient, void* self) {
  const auto seen = static_cast<Search*>(self)->look(u, gradient, Part::objective);
  if (gradient) {
    Eigen::Map<Vector> slopes(gradient, n);
    if (seen) {
      slopes = seen->gradient;
    } else {
      slopes.setZero();
    }
  }
  return seen ? seen->values.objective : HUGE_VAL;
}

void Search::equalities(unsigned, double* result, unsigned, const double* u, double* jacobian,
                        void* self) {
  static_cast<Search*>(self)->constraints(Part::equalities, result, u, jacobian);
}

void Search::inequalities(unsigned, double* result, unsigned, const double* u, double* jacobian,
                          void* self) {
  static_cast<Search*>(self)->constraints(Part::inequalities, result, u, jacobian);
}

/// One kind of the constraints: equalities come first.
void Search::constraints(Part part, double* result, const double* u, double* jacobian) {
  const Eigen::Index equalities = evaluator_.problem().equalities;
  const Eigen::Index first = part == Part::equalities ? 0 : equalities;
  const Eigen::Index end = part == Part::equalities ? equalities : evaluator_.problem().constraints;
  const Eigen::Index count = end - first;
  const auto seen = look(u, jacobian, part);
  Eigen::Map<Vector> values(result, count);
  if (seen) {
    values = seen->values.constraints.segment(first, count);
  } else {
    values.setConstant(HUGE_VAL);
  }
  if (jacobian) {
    Eigen::Map<RowMajor> slopes(jacobian, count, evaluator_.problem().dimension());
    if (seen) {
      slopes = seen->jacobian.middleRows(first, count);
    } else {
      slopes.setZero();
    }
  }
}

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

SolverExit Search::from(const Vector& start) {
  Vector u = box_.to_unit(start).cwiseMax(0.0).cwiseMin(1.0);
  // NLopt 2.7.1 reads beyond its memory when DIRECT is stopped at its first point, the middle. So
  // that is looked at beforehand; the evaluator remembers it.
  const Vector middle = Vector::Constant(u.size(), 0.5);
  if (algorithm_.id == NLOPT_GN_ORIG_DIRECT_L && !look(middle.data(), false, Part::nothing)) {
    return {ended_};
  }
  double lowest = 0;
  const nlopt_result result = nlopt_optimize(nlopt_.get(), u.data(), &lowest);
  if (thrown_) std::rethrow_exception(thrown_);
  return {ended_.empty() ? in_words(result) : ended_, box_.from_unit(u)};
}

Solver adapter(const Algorithm& algorithm, bool derivatives) {
  int version[3];
  nlopt_version(&version[0], &version[1], &version[2]);
  Solver solver;
  solver.name = fmt::format("nlopt-{}", algorithm.name);
  solver.version = fmt::format("NLopt {}", fmt::join(version, "."));
  solver.stochastic = algorithm.draws == Draws::yes;
  solver.accepts = [algorithm, derivatives](const Problem& problem) {
    return has_room(problem) && problem.dimension() >= algorithm.least_dimension &&
           (problem.constraints == 0 || algorithm.constraints != Constraints::no) &&
           (problem.equalities == 0 || algorithm.constraints == Constraints::all) &&
           (problem.differentiate || !derivatives);
  };
  solver.solve = [algorithm](Evaluator& evaluator, const Vector& start, Random& random) {
    nlopt_srand(random());  // the state is this thread's own, left over from its last run
    return Search(algorithm, evaluator).from(start);
  };
  return solver;
}

}  // namespace

std::vector<Solver> nlopt_solvers() {
  std::vector<Solver> solvers;
  for (const Algorithm& algorithm : without_derivatives) {
    solvers.push_back(adapter(algorithm, false));
  }
  for (const Algorithm& algorithm : with_derivatives) {
    solvers.push_back(adapter(algorithm, true));
  }
  return solvers;
}

}  // namespace ricochet
