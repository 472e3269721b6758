#include "src/studies/surrogate/study.h"

namespace ricochet::studies {

namespace {

report::Json results_of(bool quick) {
  using namespace surrogate;
  constexpr std::uint64_t seed = 1;
  const double step = quick ? 0.1 : 0.01;
  const std::vector<double> one = {0.25}, three = {1, 0.25, 0.05};
  const std::vector<double> narrowing =
      quick ? std::vector<double>{1, 0.25, 0.01}
            : std::vector<double>{1, 0.5, 0.25, 0.1, 0.05, 0.02, 0.01, 0.003, 0.001};
  report::Results results;
  results.set("seed", seed);
  add_bias(results, bias(step, narrowing), step);
  add_continuity(results, quick ? changes(one, 240, seed) : changes(three, 100'000, seed));
  add_gradients(results,
                quick ? gradients(one, 6, 5) : gradients({1, 0.5, 0.25, 0.1, 0.05, 0.01}, 18, 20));
  add_derivatives(results, derivatives(all_families(), quick ? 300 : 10'000, seed));
  return json_of(results);
}

}  // namespace

Study surrogate_study() {
  return {"surrogate", "A coarser study, in seconds", results_of};
}

}  // namespace ricochet::studies
