#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "bench/benchmarks.h"
#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/gradients/derivatives.h"
#include "problems/carrier_track/gradients/shape_derivatives.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "problems/carrier_track/suite/machine.h"
#include "problems/carrier_track/suite/profile.h"
#include "ricochet/machine.h"
#include "ricochet/random.h"
#include "src/core/instance.h"
#include "src/studies/suite/suite.h"

namespace ricochet::bench {

namespace {

using namespace carrier_track;

/// The surrogate as a function of the constant speed and up to four other parameters.
struct OfConstants {
  Scene scene = at_speed(scene_of(find_case("C4"), default_machine()), 6.0);
  Eigen::Index size;

  Vector start() const {
    Vector all(5);
    all << scene.omega, scene.mass, scene.wall_upper, scene.restitution_upper, scene.friction;
    return all.head(size);
  }

  template <class Scalar, class Watch>
  Scalar operator()(std::span<const Scalar> x, Watch& watch) const {
    auto near = lifted<Scalar>(scene);
    Scalar* const constants[] = {&near.omega, &near.mass, &near.wall_upper, &near.restitution_upper,
                                 &near.friction};
    for (std::size_t i = 0; i < x.size(); ++i) *constants[i] = x[i];
    auto watching = watch.of(near);
    return objective(near, default_smoothing, watching);
  }
};

/// Measures the time of one call and over_value, its ratio to the time of one value. Both are the
/// fastest of several rounds, measured alternately, because other work slows the machine at times.
template <class Function, class Work>
void derivative(benchmark::State& state, const Function& f, double allowed, const Work& work) {
  const Vector x = f.start();
  const auto [value, whole] = fastest_of([&] { benchmark::DoNotOptimize(value_of(f, x)); },
                                         [&] { benchmark::DoNotOptimize(work(f, x)); }, 10, 5e-3);
  for (auto _ : state) benchmark::DoNotOptimize(work(f, x));
  state.counters["over_value"] = whole / value;
  state.counters["allowed"] = allowed;
}

/// The gradient in blocks of `Room` directions.
template <int Room, class Function>
void add(const std::string& name, const Function& f) {
  const auto n = static_cast<double>(f.start().size());
  const auto value = [](const Function& g, const Vector& x) { return value_of(g, x); };
  const auto gradient = [](const Function& g, const Vector& x) {
    return gradient_of<Room>(g, x, Vector::Ones(x.size())).value;
  };
  const auto hessian = [](const Function& g, const Vector& x) {
    return hessian_of<(Room == 1 ? 1 : 2)>(g, x).value;
  };
  const auto of = [&](const char* what, double allowed, const auto& work) {
    benchmark::RegisterBenchmark((what + name).c_str(), [=](benchmark::State& state) {
      derivative(state, f, allowed, work);
    })->Unit(benchmark::kMicrosecond);
  };
  of("derivatives/value/", 1, value);
  of("derivatives/gradient/", std::max(3.0, 1 + n / 2), gradient);
  of("derivatives/hessian/", (1 + n) * (1 + n), hessian);
}

}  // namespace

void add_derivative_benchmarks() {
  add<1>("constants/1", OfConstants{.size = 1});
  add<5>("constants/5", OfConstants{.size = 5});
}

namespace {

/// The problem in the first of its formulations that has derivatives, original or smoothed.
std::optional<Problem> with_derivatives(const Problem& problem) {
  for (const Formulation& formulation : problem.formulations()) {
    const Problem formulated = problem.formulated(formulation);
    if (formulated.differentiate || formulated.residuals) return formulated;
  }
  return std::nullopt;
}

/// Measures over the start and points uniform in the box. Both times are the fastest of several
/// rounds, measured alternately, because other work slows the machine at times.
void cost(benchmark::State& state, const Problem& problem) {
  Random random(1);
  std::vector<Vector> points = {problem.start};
  for (int k = 0; k < 4; ++k) points.push_back(uniform_point(problem, random));
  const auto value = [&] {
    for (const Vector& x : points) benchmark::DoNotOptimize(problem.evaluate(x));
  };
  const auto both = [&] {
    for (const Vector& x : points) {
      if (problem.differentiate) {
        benchmark::DoNotOptimize(problem.differentiate(x));
      } else {
        benchmark::DoNotOptimize(problem.residuals(x));
      }
    }
  };
  const auto [of_value, of_both] = fastest_of(value, both, 5, 1e-3);
  for (auto _ : state) both();
  const double n = static_cast<double>(problem.dimension());
  state.counters["gradient"] = of_both / of_value - 1;
  state.counters["charged"] =
      problem.gradient_cost ? static_cast<double>(*problem.gradient_cost) : n;
  state.counters["n"] = n;
}

}  // namespace

void add_gradient_cost_benchmarks() {
  for (const Family& family : suite_families()) {
    std::set<Eigen::Index> sizes;
    for (const Problem& problem : family.problems) {
      const auto formulated = with_derivatives(problem);
      if (!formulated || problem.hazardous || !sizes.insert(problem.dimension()).second) continue;
      benchmark::RegisterBenchmark(
          ("gradient-cost/" + problem.name).c_str(),
          [formulated](benchmark::State& state) { cost(state, *formulated); })
          ->Unit(benchmark::kMicrosecond);
    }
  }
}

namespace {

Machine shaped_machine() {
  const Case a_case = find_case("C4");
  return {a_case.id, scene_of(a_case, default_machine()), 0, a_case.claim.threshold, {}};
}

/// The surrogate of a shape, for dual numbers.
struct SurrogateOfShape {
  Machine machine = shaped_machine();

  template <class Scalar, class Watch>
  Scalar operator()(std::span<const Scalar> x, Watch& watch) const {
    const auto scene = with_profile(lifted<Scalar>(machine.scene), profile_frame(machine), x);
    auto watching = watch.of(scene);
    return objective(scene, default_smoothing, watching);
  }
};

/// Measures the time of `work(x)` at some points x, and over_value, its ratio to the time of a
/// value. Both are the fastest of several rounds, measured alternately, because other work slows
/// the machine at times.
template <class Work>
void add(const std::string& name, std::size_t n, double allowed, const Work& work) {
  benchmark::RegisterBenchmark((name + std::to_string(n)).c_str(), [=](benchmark::State& state) {
    const Problem problem =
        profile_count_problem(shaped_machine(), n).formulated({default_smoothing});
    Random random(1);
    std::vector<Vector> points;
    for (int k = 0; k < 5; ++k) points.push_back(uniform_point(problem, random));
    const auto all = [&](const auto& each) {
      return [&points, each] {
        for (const Vector& x : points) benchmark::DoNotOptimize(each(x));
      };
    };
    const auto worked = all([&](const Vector& x) { return work(problem, x); });
    const auto [value, whole] = fastest_of(all(problem.evaluate), worked, 10, 5e-3);
    for (auto _ : state) worked();
    state.counters["over_value"] = whole / value;
    state.counters["allowed"] = allowed;
  })->Unit(benchmark::kMicrosecond);
}

}  // namespace

void add_shape_benchmarks() {
  const auto gradient = [](const Problem& problem, const Vector& x) {
    return problem.differentiate(x).gradient;
  };
  const auto by_duals = [](const Problem& problem, const Vector& x) {
    return gradient_of<16>(SurrogateOfShape(), x, problem.upper - problem.lower).gradient;
  };
  const auto times_vector = [](const Problem& /*problem*/, const Vector& x) {
    const Machine machine = shaped_machine();
    const Scene scene = with_profile(machine.scene, profile_frame(machine),
                                     std::span(x.data(), static_cast<std::size_t>(x.size())));
    return shape_curvature(SurrogateSum{default_smoothing}, scene, shaped_knots(scene, x), x);
  };
  const auto hessian = [](const Problem& problem, const Vector& x) {
    return problem.lagrangian_hessian(x, 1, {});
  };
  for (const std::size_t n : {2U, 16U, 64U, 128U, 256U}) {
    add("gradient-of-shape/", n, 4, gradient);
    add("hessian-times-vector-of-shape/", n, 10, times_vector);
  }
  for (const std::size_t n : {2U, 16U, 64U})
    add("hessian-of-shape/", n, 4.0 + static_cast<double>(n), hessian);
  for (const std::size_t n : {16U, 64U})
    add("gradient-of-shape-by-duals/", n, 1 + 0.5 * static_cast<double>(n), by_duals);
}

}  // namespace ricochet::bench
