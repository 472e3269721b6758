#include "src/identification/identified_machine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "problems/carrier_track/identification/knock_record.h"
#include "ricochet/evaluator.h"
#include "src/identification/knock_fit.h"

namespace ricochet::studies::identification {

using namespace carrier_track;

namespace {

constexpr double quantile = 1.959964;  // of a normal distribution, for 95 %

/// An interval wider than this ratio does not determine a constant.
constexpr double undetermined = 2;
constexpr double strong_correlation = 0.9;

std::vector<Estimate> constants_of(const KnockFit& fit, const KnockUnknowns& assumed) {
  const auto at = [&](double deviations) {
    Vector x = fit.x;
    for (Eigen::Index i = 0; i < machine_constants; ++i) {
      x[i] += deviations * std::sqrt(fit.covariance(i, i));
    }
    return unknowns_at(x);
  };
  const KnockUnknowns best = at(0), low = at(-quantile), high = at(quantile);
  return {
      {"restitution", "", best.restitution, low.restitution, high.restitution, assumed.restitution},
      {"friction", "", best.friction, low.friction, high.friction, assumed.friction},
      {"clearance", "m", best.clearance, low.clearance, high.clearance, assumed.clearance}};
}

/// ln of the safe speed, and its derivatives by the machine's coordinates.
struct SafeSpeed {
  double logarithm;
  Vector slopes;
};

std::optional<SafeSpeed> safe_speed_of(const Scene& scene, const KnockFit& fit, double fastest) {
  const auto at = [&](const Vector& x) {
    return safe_speed(with_constants(scene, unknowns_at(x)), fastest);
  };
  const std::optional<double> best = at(fit.x);
  if (!best) return std::nullopt;
  SafeSpeed result{std::log(*best), Vector(machine_constants)};
  for (Eigen::Index i = 0; i < machine_constants; ++i) {
    const double step = std::min(0.5 * std::sqrt(fit.covariance(i, i)), 0.01);
    Vector up = fit.x, down = fit.x;
    up[i] += step;
    down[i] -= step;
    const std::optional<double> above = at(up), below = at(down);
    if (!above || !below) return std::nullopt;
    result.slopes[i] = std::log(*above / *below) / (2 * step);
  }
  return result;
}

Estimate estimate_of(const SafeSpeed& safe, const Matrix& covariance) {
  const double deviation = std::sqrt(safe.slopes.dot(
      covariance.topLeftCorner(machine_constants, machine_constants) * safe.slopes));
  return {"safe speed", "rad/s", std::exp(safe.logarithm),
          std::exp(safe.logarithm - quantile * deviation),
          std::exp(safe.logarithm + quantile * deviation)};
}

/// NaN where the matrix is no covariance, as that of a fit that has not converged may be.
double correlation(const Matrix& covariance, Eigen::Index i, Eigen::Index j) {
  constexpr double rounding = 1e-9;
  const double r = covariance(i, j) / std::sqrt(covariance(i, i) * covariance(j, j));
  if (!(std::abs(r) <= 1 + rounding)) return std::numeric_limits<double>::quiet_NaN();
  return std::clamp(r, -1.0, 1.0);
}

bool is_covariance(const Matrix& matrix) {
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      if (std::isnan(correlation(matrix, i, j))) return false;
    }
  }
  return true;
}

Matrix correlations_of(const Matrix& covariance) {
  Matrix result(machine_constants, machine_constants);
  for (Eigen::Index i = 0; i < machine_constants; ++i) {
    for (Eigen::Index j = 0; j < machine_constants; ++j) {
      result(i, j) = correlation(covariance, i, j);
    }
  }
  return result;
}

std::string name(Eigen::Index i) {
  return std::string(constant_names[static_cast<std::size_t>(i)]);
}

/// What the record cannot tell apart.
std::vector<std::string> remarks_of(const IdentifiedMachine& machine, const KnockRecord& record) {
  std::vector<std::string> remarks;
  for (const Estimate& constant : machine.constants) {
    const double ratio = constant.upper / constant.lower;
    if (ratio < undetermined) continue;
    remarks.push_back(
        fmt::format("The record does not determine the {}: its interval spans a factor of {:.3g}.",
                    constant.name, ratio));
  }
  for (Eigen::Index i = 0; i < machine_constants; ++i) {
    for (Eigen::Index j = i + 1; j < machine_constants; ++j) {
      const double r = machine.correlations(i, j);
      if (!(std::abs(r) >= strong_correlation)) continue;
      remarks.push_back(fmt::format(
          "{} and {} are hard to tell apart (correlation {:.2f}): more of one with {} of the other "
          "explains the knocks almost as well.",
          name(i), name(j), r, r > 0 ? "more" : "less"));
    }
  }
  if (record.plate) return remarks;
  for (Eigen::Index i = 0; i < machine_constants; ++i) {
    const double r = correlation(machine.fit.covariance, i, coordinate::phase);
    if (!(std::abs(r) >= strong_correlation)) continue;
    remarks.push_back(
        fmt::format("{} and the plate's unknown angle are hard to tell apart (correlation {:.2f}): "
                    "a mark on the plate (--marks) would fix the angle.",
                    name(i), r));
  }
  return remarks;
}

void add_warnings(IdentifiedMachine& machine) {
  const KnockUnknowns at = unknowns_at(machine.fit.x);
  if (std::abs(at.recorded_share - at.upper_share) > 0.2) {
    machine.remarks.push_back(fmt::format(
        "The sensor records {:.0f} % of the impacts on the lower wall and {:.0f} % of those on the "
        "upper one.",
        100 * at.recorded_share, 100 * at.upper_share));
  }
  if (!machine.has_covariance) {
    machine.remarks.push_back("The fit has not converged: no interval is known.");
  } else if (machine.fit.excess > 0.1) {
    machine.remarks.push_back("The fit has not converged: the intervals are too narrow.");
  }
}

/// Chooses what to make more certain: the safe speed, or else the least certain constant.
void add_next_speed(IdentifiedMachine& machine, const KnockLoss& loss,
                    const std::optional<SafeSpeed>& safe, double fastest) {
  Vector target = Vector::Zero(machine_constants);
  machine.next_target = "safe speed";
  if (safe) {
    target = safe->slopes;
  } else {
    Vector deviations = slopes_at(machine.fit.x);
    for (Eigen::Index i = 0; i < machine_constants; ++i) {
      deviations[i] *= std::sqrt(machine.fit.covariance(i, i)) /
                       machine.constants[static_cast<std::size_t>(i)].value;
    }
    Eigen::Index worst = 0;
    deviations.maxCoeff(&worst);
    machine.next_target = name(worst);
    target[worst] =
        slopes_at(machine.fit.x)[worst] / machine.constants[static_cast<std::size_t>(worst)].value;
  }
  machine.next = next_speed(loss, machine.fit.x, target, fastest);
}

}  // namespace

IdentifiedMachine identify(const KnockLoss& loss, const Solver& solver, double fastest) {
  IdentifiedMachine machine;
  machine.fit = fit_knocks(loss, solver);
  const KnockFit& fit = machine.fit;
  machine.has_covariance = !fit.complete || is_covariance(fit.covariance.topLeftCorner(
                                                machine_constants, machine_constants));
  if (!machine.has_covariance) machine.fit.covariance.setZero();
  if (!fit.x.allFinite()) throw std::runtime_error("no machine was found that makes these knocks");
  const KnockUnknowns found = unknowns_at(fit.x);
  machine.scene = with_constants(loss.scene(), found);
  machine.constants = constants_of(fit, guess_of(loss.scene()));
  machine.correlations = fit.complete ? correlations_of(fit.covariance)
                                      : Matrix::Identity(machine_constants, machine_constants);
  const double knocks = static_cast<double>(loss.record().knocks.size());
  machine.explained_share =
      std::max(0.0, 1 - found.spurious_rate * loss.record().duration() / knocks);
  machine.missed_share = 1 - (found.recorded_share + found.upper_share) / 2;
  machine.remarks = loss.record().notes;
  machine.complete = fit.complete;
  if (!machine.complete) return machine;
  for (std::string& remark : remarks_of(machine, loss.record())) {
    machine.remarks.push_back(std::move(remark));
  }
  add_warnings(machine);
  try {
    machine.contradictions = contradictions(loss, fit, solver);
    const std::optional<SafeSpeed> safe = safe_speed_of(loss.scene(), fit, fastest);
    if (safe) machine.safe_speed = estimate_of(*safe, fit.covariance);
    add_next_speed(machine, loss, safe, fastest);
  } catch (const TimeLimitReached&) {
    machine.complete = false;
    machine.safe_speed.reset();
  }
  return machine;
}

}  // namespace ricochet::studies::identification
