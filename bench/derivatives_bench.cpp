#include "bench/derivatives_bench.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "bench/processor_time.h"
#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/gradients/derivatives.h"
#include "problems/carrier_track/problems/cases.h"
#include "problems/carrier_track/problems/default_machine.h"
#include "problems/carrier_track/scene/lifted.h"

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

}  // namespace ricochet::bench
