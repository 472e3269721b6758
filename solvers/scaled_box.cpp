#include "solvers/scaled_box.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ricochet {

EnumNames<Coordinates> names_of(Coordinates) {
  return {{"unit", Coordinates::unit}, {"even", Coordinates::even}, {"own", Coordinates::own}};
}

ScaledBox::ScaledBox(Evaluator& evaluator, Coordinates coordinates) : evaluator_(evaluator) {
  const Vector width = evaluator.upper() - evaluator.lower();
  const bool own = coordinates == Coordinates::own;
  const double longest = own ? 1 : width.maxCoeff();
  const auto has_width = width.array() > 0;
  origin_ = own ? Vector(has_width.select(0.0, evaluator.lower())) : evaluator.lower();
  scale_ = coordinates == Coordinates::unit ? width : Vector(has_width.select(longest, width));
  lower_ = has_width.select((evaluator.lower() - origin_).cwiseQuotient(scale_), 0.0);
  upper_ = has_width.select((evaluator.upper() - origin_).cwiseQuotient(scale_), 1.0);
}

Vector ScaledBox::to_scaled(const Vector& x) const {
  const Vector u = (scale_.array() > 0).select((x - origin_).cwiseQuotient(scale_), 0.0);
  return u.cwiseMax(lower_).cwiseMin(upper_);
}

Vector ScaledBox::from_scaled(const Vector& u) const {
  return origin_ + scale_.cwiseProduct(u);
}

std::optional<Values> ScaledBox::values(const Vector& u, Part part) {
  if (!u.allFinite()) return std::nullopt;
  return evaluator_.values(from_scaled(u), part);
}

std::optional<Derivatives> ScaledBox::derivatives(const Vector& u, Part part) {
  if (!u.allFinite()) return std::nullopt;
  auto shown = evaluator_.derivatives(from_scaled(u), part);
  if (!shown) return std::nullopt;
  shown->gradient.array() *= scale_.array();
  shown->jacobian *= scale_.asDiagonal();
  return shown;
}

std::optional<Matrix> ScaledBox::lagrangian_hessian(const Vector& u, double objective_factor,
                                                    const Vector& multipliers) {
  if (!u.allFinite()) return std::nullopt;
  auto shown = evaluator_.lagrangian_hessian(from_scaled(u), objective_factor, multipliers);
  if (shown) *shown = scale_.asDiagonal() * *shown * scale_.asDiagonal();
  return shown;
}

std::optional<Residuals> ScaledBox::residuals(const Vector& u, Part part) {
  if (!u.allFinite()) return std::nullopt;
  auto shown = evaluator_.residuals(from_scaled(u), part);
  if (shown) shown->jacobian *= scale_.asDiagonal();
  return shown;
}

std::optional<Vector> ScaledBox::residual_values(const Vector& u, Part part) {
  if (!u.allFinite()) return std::nullopt;
  return evaluator_.residual_values(from_scaled(u), part);
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
