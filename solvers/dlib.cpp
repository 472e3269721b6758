#include <dlib/global_optimization/global_function_search.h>
#include <dlib/revision.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <vector>

#include "solvers/library_solvers.h"
#include "solvers/scaled_box.h"

namespace ricochet {

namespace {

constexpr std::size_t most_points = 400;
constexpr std::size_t samples = 1000;  // of the upper bound, to find its highest point

using Column = dlib::matrix<double, 0, 1>;
using Evaluations = std::vector<dlib::function_evaluation>;

Column column(const Vector& u) {
  Column x(u.size());
  std::copy(u.begin(), u.end(), x.begin());
  return x;
}

/// Returns true if dlib's model can be built from these: it divides by zero if all values are
/// equal.
bool suffice(const Evaluations& evaluations, Eigen::Index n) {
  const auto differs = [&](const auto& evaluation) { return evaluation.y != evaluations[0].y; };
  return std::ssize(evaluations) >= std::max<Eigen::Index>(3, n) &&
         std::any_of(evaluations.begin(), evaluations.end(), differs);
}

/// The start and points uniform in the box, those with finite values. May be too few for the model
/// if the evaluator refuses or the limit is reached. dlib maximises, so the values have the
/// opposite sign.
Evaluations first_points(ScaledBox& box, const Vector& start, Random& random) {
  Evaluations evaluations;
  Vector x = start;
  for (std::size_t asked = 0; asked < most_points; ++asked) {
    const Vector u = box.to_scaled(x);
    const auto values = box.values(u);
    if (!values) break;
    if (finite(*values)) evaluations.emplace_back(column(u), -values->objective);
    if (suffice(evaluations, u.size())) break;
    x = uniform_point(box.evaluator().lower(), box.evaluator().upper(), random);
  }
  return evaluations;
}

struct Options {
  Coordinates coordinates = Coordinates::unit;
};

template <class Visit, IsOf<Options>... O>
void visit_fields(const Visit& visit, O&... o) {
  visit(coordinates_option, o.coordinates...);
}

SolverTermination minimise(const Options& options, Evaluator& evaluator, const Vector& start,
                           Random& random) {
  ScaledBox box(evaluator, options.coordinates);
  const Evaluations first = first_points(box, start, random);
  if (evaluator.over()) return {stopped_by_evaluator};
  if (!suffice(first, start.size())) return {"no two values differ"};
  const auto is_lower = [](const auto& a, const auto& b) { return a.y < b.y; };
  double worst = std::min_element(first.begin(), first.end(), is_lower)->y;
  const dlib::function_spec spec(column(box.lower()), column(box.upper()));
  dlib::global_function_search search({spec}, {first});
  search.set_monte_carlo_upper_bound_sample_num(samples);
  search.set_seed(static_cast<std::time_t>(random()));
  for (std::size_t points = first.size(); points < most_points; ++points) {
    dlib::function_evaluation_request request = search.get_next_x();
    const Column& asked = request.x();
    const auto values = box.values(Vector(Eigen::Map<const Vector>(asked.begin(), asked.size())));
    if (!values) return {evaluator.over() ? stopped_by_evaluator : not_finite};
    if (finite(*values)) worst = std::min(worst, -values->objective);
    request.set(finite(*values) ? -values->objective : worst);
  }
  return {"the model has all points that it may have"};
}

Solver made(const Options& options) {
  Solver solver;
  solver.name = "dlib-global-search";
  solver.version =
      fmt::format("dlib {}.{}.{}", DLIB_MAJOR_VERSION, DLIB_MINOR_VERSION, DLIB_PATCH_VERSION);
  solver.stochastic = true;
  solver.capabilities = dlib_capabilities;
  solver.solve = [options](Evaluator& evaluator, const Vector& start, Random& random) {
    return minimise(options, evaluator, start, random);
  };
  return solver;
}

}  // namespace

Solver dlib_global_search() {
  return made({});
}

AdjustableSolver adjustable_dlib() {
  return adjustable("dlib-global-search", Options(), made);
}

}  // namespace ricochet
