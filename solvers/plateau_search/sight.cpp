#include "solvers/plateau_search/sight.h"

#include <bit>
#include <cmath>
#include <limits>

#include "solvers/unit_box.h"

namespace ricochet::drifting {

bool tied(const Truth& a, const Truth& b) {
  return !better(a, b) && !better(b, a);
}

Sight::Sight(Evaluator& evaluator)
    : evaluator_(evaluator),
      lower_(evaluator.problem().lower),
      width_(evaluator.problem().upper - evaluator.problem().lower) {
  if (problem().smoothed && problem().differentiate) show(0.0);
}

Vector Sight::inside(const Vector& u) const {
  return (width_.array() > 0).select(u.cwiseMax(0.0).cwiseMin(1.0), 0.0);
}

Vector Sight::to_unit(const Vector& x) const {
  return inside((width_.array() > 0).select((x - lower_).cwiseQuotient(width_), 0.0));
}

Vector Sight::from_unit(const Vector& u) const {
  return lower_ + width_.cwiseProduct(u);
}

Vector Sight::uniform_point(Random& random) const {
  Vector u(width_.size());
  for (double& coordinate : u) coordinate = uniform(random);
  return inside(u);
}

void Sight::show(std::optional<double> width) {
  if (width == shown_ || !width) return;
  evaluator_.smooth(*width);
  shown_ = width;
}

/// Fowler, Noll and Vo's hash, of the coordinates' bits.
std::uint64_t Sight::key_of(const Vector& u) {
  std::uint64_t key = 14695981039346656037U;
  for (const double coordinate : u) {
    key = (key ^ std::bit_cast<std::uint64_t>(coordinate + 0.0)) * 1099511628211U;
    key ^= key >> 29U;
  }
  return key;
}

std::optional<Truth> Sight::look(const Vector& u) {
  if (shown_) show(0.0);
  const auto values = evaluator_.values(from_unit(u));
  if (!values) return std::nullopt;
  asked_.insert(key_of(u));
  broken_.clear();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Truth truth{infinity, infinity};
  if (finite(*values)) {
    truth = truth_of(*values);
    for (Eigen::Index j = 0; j < values->constraints.size(); ++j) {
      if (values->constraints[j] > 0) broken_.push_back(j);
    }
  }
  if (!best_ || better(truth, best_->truth)) best_ = Seen{u, truth};
  return truth;
}

std::optional<double> Sight::objective(const Vector& u, std::optional<double> width) {
  if (!width) {
    const auto truth = look(u);
    return truth ? std::optional(truth->objective) : std::nullopt;
  }
  show(width);
  return evaluator_.objective(from_unit(u));
}

std::optional<Derivatives> Sight::slopes(const Vector& u, std::optional<double> width) {
  show(width);
  auto derivatives = evaluator_.derivatives(from_unit(u));
  if (derivatives) derivatives->gradient.array() *= width_.array();
  return derivatives;
}

}  // namespace ricochet::drifting
