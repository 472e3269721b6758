#include "src/benchmark/experiment/perturbations/failures.h"

#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

#include "src/benchmark/experiment/perturbations/perturbed_calls.h"
#include "src/benchmark/experiment/perturbations/telling.h"
#include "src/core/processor_time.h"

namespace ricochet {
namespace {

void lose(Eigen::Ref<Vector> values, Eigen::Ref<Matrix> slopes, Draws& draws) {
  constexpr double probability = 0.05;
  if (draws.uniform() >= probability) return;
  values.setConstant(std::numeric_limits<double>::quiet_NaN());
  slopes.setConstant(std::numeric_limits<double>::quiet_NaN());
}

/// Calls a function before every call of a solver; the results stay unchanged.
class Before : public PerturbedCalls {
 public:
  explicit Before(std::function<void()> before) : before_(std::move(before)) {}

  Values values(const Problem& shown, const Vector& x) override {
    before_();
    return shown.evaluate(x);
  }
  Derivatives derivatives(const Problem& shown, const Vector& x) override {
    before_();
    return shown.differentiate(x);
  }
  Residuals residuals(const Problem& shown, const Vector& x) override {
    before_();
    return shown.residuals(x);
  }
  Matrix hessian(const Problem& shown, const Vector& x, double objective_factor,
                 const Vector& multipliers) override {
    before_();
    return shown.lagrangian_hessian(x, objective_factor, multipliers);
  }

 private:
  std::function<void()> before_;
};

void compute_for_a_while() {
  constexpr double seconds = 1e-4;
  const double end = processor_seconds() + seconds;
  while (processor_seconds() < end) continue;
}

}  // namespace

Perturbation not_a_number() {
  return {"nan", "every function told is NaN with probability 0.05, drawn anew at every call",
          [](const Problem&) { return true; },
          [](const Problem& shown, std::uint64_t seed) {
            return told_by(lose, Drawn::by_call, key_of(seed, "nan"), shown);
          }};
}

Perturbation throwing() {
  return {"throwing", "every call throws with probability 1e-3, which ends the run",
          [](const Problem&) { return true; },
          [](const Problem& shown, std::uint64_t seed) {
            constexpr double probability = 1e-3;
            const auto before = [draws = Draws(key_of(seed, "throwing"))]() mutable {
              if (draws.uniform() < probability) throw std::runtime_error("an evaluation failed");
            };
            return perturbed_by(std::make_shared<Before>(before), shown);
          }};
}

Perturbation slow() {
  return {"slow", "every call takes 0.1 ms of processor time more",
          [](const Problem&) { return true; },
          [](const Problem& shown, std::uint64_t) {
            return perturbed_by(std::make_shared<Before>(compute_for_a_while), shown);
          }};
}

}  // namespace ricochet
