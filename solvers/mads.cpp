#include "solvers/mads.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "solvers/scaled_box.h"

namespace ricochet {

namespace {

/// Returns true if `a` is no worse than `b` in objective and violation.
bool no_worse(const Trial& a, const Trial& b) {
  return a.objective <= b.objective && a.violation <= b.violation;
}

bool dominates(const Trial& a, const Trial& b) {
  return no_worse(a, b) && !no_worse(b, a);
}

}  // namespace

double violation_of(const Values& values, Eigen::Index equalities) {
  double sum = 0;
  for (Eigen::Index i = 0; i < values.constraints.size(); ++i) {
    const double violation = violation_of(values.constraints[i], i < equalities);
    sum += violation * violation;
  }
  return sum;
}

Progress Barrier::add(const Trial& trial) {
  if (!std::isfinite(trial.objective) || !std::isfinite(trial.violation)) return Progress::none;
  return trial.violation > 0 ? add_infeasible(trial) : add_feasible(trial);
}

Progress Barrier::add_feasible(const Trial& trial) {
  const bool ties = next_feasible_ && trial.objective == next_feasible_->objective;
  if (!next_feasible_ || trial.objective < next_feasible_->objective || (ties && accepts_ties_)) {
    next_feasible_ = trial;
  }
  const bool beats = !feasible_ || trial.objective < feasible_->objective;
  return beats ? Progress::dominating : Progress::none;
}

Progress Barrier::add_infeasible(const Trial& trial) {
  if (trial.violation > limit_) return Progress::none;
  const auto beats = [&](const Trial& other) { return no_worse(other, trial); };
  if (std::any_of(undominated_.begin(), undominated_.end(), beats)) return Progress::none;
  std::erase_if(undominated_, [&](const Trial& other) { return dominates(trial, other); });
  undominated_.push_back(trial);
  if (!infeasible_) return Progress::none;  // there is no incumbent to beat
  if (dominates(trial, *infeasible_)) return Progress::dominating;
  return trial.violation < infeasible_->violation ? Progress::improving : Progress::none;
}

void Barrier::settle(Progress progress) {
  feasible_ = next_feasible_;
  if (infeasible_) {
    double limit = infeasible_->violation;
    if (progress == Progress::improving) {
      limit = 0;
      for (const Trial& trial : undominated_) {
        if (trial.violation < infeasible_->violation) limit = std::max(limit, trial.violation);
      }
    }
    limit_ = limit;
  }
  std::erase_if(undominated_, [&](const Trial& trial) { return trial.violation > limit_; });
  infeasible_.reset();
  for (const Trial& trial : undominated_) {
    if (!infeasible_ || trial.objective < infeasible_->objective) infeasible_ = trial;
  }
}

namespace {

/// The defaults are those of NOMAD.
struct Options {
  double scale = 0.1;          ///< mesh and poll at index 0, as a share of the box
  int coarsest = -3;           ///< index, with polls at 0.8 of the box
  int mesh_index = 0;          ///< at the beginning
  double finest_mesh = 1e-15;  ///< of the box: ours, with polls at 1e-8 of it
  double further = 3;          ///< how far to look ahead after a success, in lengths of its step
  double trigger = 0.1;        ///< the infeasible incumbent comes first if it is so much lower
  bool accepts_ties = false;   ///< see Barrier
};

/// What did best on this suite.
constexpr Options tuned_options = {.scale = 1,
                                   .coarsest = 1,
                                   .mesh_index = 2,
                                   .finest_mesh = 1e-8,
                                   .trigger = std::numeric_limits<double>::infinity(),
                                   .accepts_ties = true};

template <class Visit, IsOf<Options>... O>
void visit_fields(const Visit& visit, O&... o) {
  visit(real_option("finest_mesh", 1e-15, 0.25), o.finest_mesh...);
  visit(whole_option("mesh_index", 0, 12), o.mesh_index...);
  visit(real_option("further", 0, 100), o.further...);
}

/// The search from one start.
class Search {
 public:
  Search(Evaluator& evaluator, Random& random, const Options& options)
      : options_(options),
        evaluator_(evaluator),
        random_(random),
        box_(evaluator),
        has_width_(evaluator.upper().array() > evaluator.lower().array()),
        mesh_(options.mesh_index, options.coarsest, options.scale),
        barrier_(options.accepts_ties) {}

  SolverTermination run(const Vector& start) {
    start_ = inside(box_.to_scaled(start));
    try_point(start_);
    barrier_.settle(Progress::none);
    last_step_ = normal(start_.size(), random_);  // any direction is as good as another
    while (mesh_.spacing() >= options_.finest_mesh && !evaluator_.over()) iterate();
    return {evaluator_.over() ? stopped_by_evaluator : "the mesh is fine"};
  }

 private:
  void iterate() {
    Progress progress = succeeded_ ? look_further() : Progress::none;
    if (progress != Progress::dominating) progress = std::max(progress, poll());
    barrier_.settle(progress);
    succeeded_ = progress == Progress::dominating;
    if (succeeded_) mesh_.coarsen();
    if (progress == Progress::none) mesh_.refine();
  }

  Progress look_further() { return try_step(last_success_, options_.further * last_step_); }

  Progress poll() {
    const Matrix basis = poll_basis(normal(start_.size(), random_), std::abs(mesh_.index()));
    const std::vector<Vector> directions = poll_directions(basis, last_step_);
    const auto& feasible = barrier_.feasible();
    const auto& infeasible = barrier_.infeasible();
    if (!feasible) return poll_around(infeasible ? infeasible->u : start_, directions);
    if (!infeasible || infeasible->objective >= feasible->objective) {
      return poll_around(feasible->u, directions);
    }
    const bool swapped = infeasible->objective < feasible->objective - options_.trigger;
    const auto [first, second] =
        swapped ? std::pair(infeasible->u, feasible->u) : std::pair(feasible->u, infeasible->u);
    const Progress progress = poll_around(first, directions);
    if (progress == Progress::dominating) return progress;
    const Vector& along = directions.front();
    return std::max(progress, poll_around(second, {along, -along}));
  }

  Progress poll_around(const Vector& centre, const std::vector<Vector>& directions) {
    Progress progress = Progress::none;
    for (const Vector& direction : directions) {
      progress = std::max(progress, try_step(centre, mesh_.spacing() * direction));
      if (progress == Progress::dominating) break;
    }
    return progress;
  }

  Progress try_step(const Vector& centre, const Vector& step) {
    const Vector u = inside(centre + step);
    const Progress progress = try_point(u);
    if (progress == Progress::dominating) {
      last_step_ = u - centre;
      last_success_ = u;
    }
    return progress;
  }

  /// Tries a point. One that was tried before is no progress and costs no evaluation.
  Progress try_point(const Vector& u) {
    if (!tried_.insert({u.begin(), u.end()}).second) return Progress::none;
    const auto values = evaluator_.values(box_.from_scaled(u));
    if (!values) return Progress::none;
    return barrier_.add({u, values->objective, violation_of(*values, evaluator_.equalities())});
  }

  /// The nearest point of the unit box; a coordinate whose box has width 0 stays as it is.
  Vector inside(const Vector& u) const {
    return has_width_.select(u.cwiseMax(0.0).cwiseMin(1.0), 0.0);
  }

  Options options_;
  Evaluator& evaluator_;
  Random& random_;
  ScaledBox box_;
  Eigen::Array<bool, Eigen::Dynamic, 1> has_width_;
  Mesh mesh_;
  Barrier barrier_;
  std::set<std::vector<double>> tried_;
  Vector start_;
  Vector last_success_, last_step_;
  bool succeeded_ = false;
};

Solver made(const std::string& name, const Options& options) {
  Solver solver;
  solver.name = name;
  solver.version = "ricochet " RICOCHET_VERSION;
  if (name == "mads") solver.version += " (adapter 2)";  // the first was what is now mads-tuned
  solver.stochastic = true;
  solver.capabilities.constraints = Capabilities::Constraints::all;
  solver.solve = [options](Evaluator& evaluator, const Vector& start, Random& random) {
    return Search(evaluator, random, options).run(start);
  };
  return solver;
}

}  // namespace

Solver mads(Settings settings) {
  return settings == Settings::tuned ? made("mads-tuned", tuned_options) : made("mads", {});
}

std::vector<AdjustableSolver> adjustable_mads() {
  const auto named = [](const char* name) {
    return [=](const Options& options) { return made(name, options); };
  };
  return {adjustable("mads", Options(), named("mads")),
          adjustable("mads-tuned", tuned_options, named("mads-tuned"))};
}

namespace {

Vector rounded(const Vector& x) {
  return x.unaryExpr([](double each) { return std::round(each); });
}

/// The longest integer vector along `direction` with a norm of at most `most`, >= 1.
Vector integers_along(const Vector& direction, double most) {
  Eigen::Index largest = 0;
  const Vector along = direction / direction.cwiseAbs().maxCoeff(&largest);
  Vector best = Vector::Zero(direction.size());
  best[largest] = along[largest];  // 1 or -1
  double shorter = 0;
  double longer = most + 1;       // then even the largest coordinate alone is too long
  constexpr int bisections = 60;  // to machine precision
  for (int i = 0; i < bisections; ++i) {
    const double middle = (shorter + longer) / 2;
    const Vector q = rounded(middle * along);
    const bool fits = q.norm() <= most;
    (fits ? shorter : longer) = middle;
    if (fits && q.squaredNorm() > best.squaredNorm()) best = q;
  }
  return best;
}

}  // namespace

Matrix poll_basis(const Vector& direction, int index) {
  const Vector q = integers_along(direction, std::sqrt(std::ldexp(1.0, index)));
  const Eigen::Index n = q.size();
  return q.squaredNorm() * Matrix::Identity(n, n) - 2 * q * q.transpose();
}

std::vector<Vector> poll_directions(const Matrix& basis, const Vector& leading) {
  std::vector<Vector> directions;
  Vector sum = Vector::Zero(leading.size());
  for (const auto& column : basis.colwise()) {
    directions.emplace_back(column.dot(leading) < 0 ? Vector(-column) : Vector(column));
    sum += directions.back();
  }
  std::stable_sort(directions.begin(), directions.end(), [&](const Vector& a, const Vector& b) {
    return a.dot(leading) > b.dot(leading);
  });
  directions.emplace_back(-sum);
  return directions;
}

}  // namespace ricochet
