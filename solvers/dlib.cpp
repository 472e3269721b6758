#include <dlib/global_optimization/global_function_search.h>
#include <dlib/revision.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <vector>

#include "solvers/library_solvers.h"
#include "solvers/unit_box.h"

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
Evaluations first_points(UnitBox& box, const Vector& start, Random& random) {
  Evaluations evaluations;
  Vector x = start;
  for (std::size_t asked = 0; asked < most_points; ++asked) {
    const Vector u = box.to_unit(x).cwiseMax(0.0).cwiseMin(1.0);
    const auto values = box.values(u);
    if (!values) break;
    if (finite(*values)) evaluations.emplace_back(column(u), -values->objective);
    if (suffice(evaluations, u.size())) break;
    x = uniform_point(box.evaluator().lower(), box.evaluator().upper(), random);
  }
  return evaluations;
}

SolverTermination minimise(Evaluator& evaluator, const Vector& start, Random& random) {
  UnitBox box(evaluator);
  const Evaluations first = first_points(box, start, random);
  if (evaluator.over()) return {stopped_by_evaluator};
  if (!suffice(first, start.size())) return {"no two values differ"};
  const auto is_lower = [](const auto& a, const auto& b) { return a.y < b.y; };
  double worst = std::min_element(first.begin(), first.end(), is_lower)->y;
  const dlib::function_spec cube(column(Vector::Zero(start.size())),
                                 column(Vector::Ones(start.size())));
  dlib::global_function_search search({cube}, {first});
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

}  // namespace

Solver dlib_global_search() {
  Solver solver;
  solver.name = "dlib-global-search";
  solver.version =
      fmt::format("dlib {}.{}.{}", DLIB_MAJOR_VERSION, DLIB_MINOR_VERSION, DLIB_PATCH_VERSION);
  solver.stochastic = true;
  solver.capabilities = dlib_capabilities;
  solver.solve = minimise;
  return solver;
}

}  // namespace ricochet
