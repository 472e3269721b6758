#include "src/benchmark/experiment/perturbations/telling.h"

#include <memory>
#include <utility>

#include "src/benchmark/experiment/perturbations/perturbed_calls.h"

namespace ricochet {
namespace {

// The number of the residuals; objective and constraints are counted from 0.
constexpr std::uint64_t of_residuals = UINT64_MAX;
constexpr std::uint64_t of_hessian = UINT64_MAX - 1;

class Telling : public PerturbedCalls {
 public:
  Telling(Tell tell, Drawn drawn, std::uint64_t key)
      : tell_(std::move(tell)), drawn_(drawn), key_(key) {}

  Values values(const Problem& shown, const Vector& x) override {
    Values told = shown.evaluate(x);
    const std::uint64_t key = key_at(x);
    Matrix none;
    tell_values(told, key, [&none](Eigen::Index) -> Eigen::Ref<Matrix> { return none; });
    return told;
  }

  Derivatives derivatives(const Problem& shown, const Vector& x) override {
    Derivatives told = shown.differentiate(x);
    const std::uint64_t key = key_at(x);
    tell_values(told.values, key, [&told](Eigen::Index function) -> Eigen::Ref<Matrix> {
      if (function == 0) return told.gradient;
      return told.jacobian.middleRows(function - 1, 1);
    });
    return told;
  }

  Residuals residuals(const Problem& shown, const Vector& x) override {
    Residuals told = shown.residuals(x);
    Draws draws(key_of(key_at(x), of_residuals));
    tell_(told.values, told.jacobian, draws);
    return told;
  }

  Matrix hessian(const Problem& shown, const Vector& x, double objective_factor,
                 const Vector& multipliers) override {
    Matrix told = shown.lagrangian_hessian(x, objective_factor, multipliers);
    Draws draws(key_of(key_at(x), of_hessian));
    Vector none;
    tell_(none, told, draws);
    return told.selfadjointView<Eigen::Upper>();
  }

 private:
  std::uint64_t key_at(const Vector& x) {
    return drawn_ == Drawn::by_point ? key_of(key_, x) : key_of(key_, calls_++);
  }

  template <class SlopesOf>
  void tell_values(Values& told, std::uint64_t key, SlopesOf slopes_of) {
    for (Eigen::Index function = 0; function <= told.constraints.size(); ++function) {
      Draws draws(key_of(key, static_cast<std::uint64_t>(function)));
      double& value = function == 0 ? told.objective : told.constraints[function - 1];
      tell_(Eigen::Map<Vector>(&value, 1), slopes_of(function), draws);
    }
  }

  Tell tell_;
  Drawn drawn_;
  std::uint64_t key_;
  std::uint64_t calls_ = 0;
};

}  // namespace

Problem told_by(const Tell& tell, Drawn drawn, std::uint64_t key, const Problem& shown) {
  return perturbed_by(std::make_shared<Telling>(tell, drawn, key), shown);
}

}  // namespace ricochet
