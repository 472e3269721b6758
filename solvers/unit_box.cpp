#include "solvers/unit_box.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ricochet {

UnitBox::UnitBox(Evaluator& evaluator)
    : evaluator_(evaluator),
      lower_(evaluator.lower()),
      width_(evaluator.upper() - evaluator.lower()) {}

Vector UnitBox::to_unit(const Vector& x) const {
  return (width_.array() > 0).select((x - lower_).cwiseQuotient(width_), 0.0);
}

Vector UnitBox::from_unit(const Vector& u) const {
  return lower_ + width_.cwiseProduct(u);
}

std::optional<Values> UnitBox::values(const Vector& u, Part part) {
  if (!u.allFinite()) return std::nullopt;
  return evaluator_.values(from_unit(u), part);
}

std::optional<Derivatives> UnitBox::derivatives(const Vector& u, Part part) {
  if (!u.allFinite()) return std::nullopt;
  auto shown = evaluator_.derivatives(from_unit(u), part);
  if (!shown) return std::nullopt;
  shown->gradient.array() *= width_.array();
  shown->jacobian *= width_.asDiagonal();
  return shown;
}

std::optional<Matrix> UnitBox::lagrangian_hessian(const Vector& u, double objective_factor,
                                                  const Vector& multipliers) {
  if (!u.allFinite()) return std::nullopt;
  auto shown = evaluator_.lagrangian_hessian(from_unit(u), objective_factor, multipliers);
  if (shown) *shown = width_.asDiagonal() * *shown * width_.asDiagonal();
  return shown;
}

std::optional<Residuals> UnitBox::residuals(const Vector& u, Part part) {
  if (!u.allFinite()) return std::nullopt;
  auto shown = evaluator_.residuals(from_unit(u), part);
  if (shown) shown->jacobian *= width_.asDiagonal();
  return shown;
}

std::optional<Vector> UnitBox::residual_values(const Vector& u, Part part) {
  if (!u.allFinite()) return std::nullopt;
  return evaluator_.residual_values(from_unit(u), part);
}

bool finite(const Values& values) {
  return std::isfinite(values.objective) && values.constraints.allFinite();
}

bool finite(const Derivatives& derivatives) {
  return finite(derivatives.values) && derivatives.gradient.allFinite() &&
         derivatives.jacobian.allFinite();
}

bool finite(const Residuals& residuals) {
  return residuals.values.allFinite() && residuals.jacobian.allFinite();
}

}  // namespace ricochet

#ifndef RICOCHET_HAS_PAGMO
#include "ricochet/error.h"
#endif

namespace ricochet {

bool dominates(const Vector& a, const Vector& b) {
  return (a.array() <= b.array()).all() && (a.array() < b.array()).any();
}

void add(Front& front, FrontPoint point) {
  const auto as_good = [&](const FrontPoint& other) {
    return (other.goals.array() <= point.goals.array()).all();
  };
  if (std::any_of(front.begin(), front.end(), as_good)) return;
  std::erase_if(front,
                [&](const FrontPoint& other) { return dominates(point.goals, other.goals); });
  front.push_back(std::move(point));
}

#ifndef RICOCHET_HAS_PAGMO
Front nsga2_front(const SeveralGoals& /*problem*/, const FrontSearch& /*search*/) {
  throw InputError("this build has no pagmo, which searches for fronts");
}

double hypervolume(const Front& /*front*/, const Vector& /*reference*/) {
  throw InputError("this build has no pagmo, which measures fronts");
}
#endif

}  // namespace ricochet
