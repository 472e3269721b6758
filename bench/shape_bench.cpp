#include "bench/shape_bench.h"

#include <benchmark/benchmark.h>

#include <span>
#include <string>
#include <vector>

#include "bench/processor_time.h"
#include "problems/carrier_track/gradients/derivatives.h"
#include "problems/carrier_track/gradients/event_sums.h"
#include "problems/carrier_track/gradients/shape_derivatives.h"
#include "problems/carrier_track/problems/cases.h"
#include "problems/carrier_track/problems/default_machine.h"
#include "problems/carrier_track/problems/profile.h"
#include "problems/carrier_track/scene/lifted.h"
#include "ricochet/random.h"
#include "ricochet/simulate.h"
#include "src/core/instance.h"

namespace ricochet::bench {
namespace {

using namespace carrier_track;

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
