#include "src/research/calibration/sensitivity.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ricochet/threshold.h"
#include "src/research/calibration/appraisal.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

constexpr double change = 0.02;

std::optional<double> threshold_of(const Fit& fit, const Constants& constants, const Case& c,
                                   double step) {
  const SpeedScan scan = scan_of(c, fit.interpretation, constants, step);
  return score(counts_of(c, fit.interpretation, constants), c.claim, scan, 1).threshold;
}

/// The slope of ln(threshold); see CaseSensitivity.
std::optional<double> slope_of(const Fit& fit, const Case& c, Unknown open, double step) {
  const auto i = static_cast<std::size_t>(open);
  const UnknownParameter& bounds = unknown_parameters()[i];
  std::array<double, 2> at{};
  std::array<double, 2> thresholds{};
  for (const std::size_t side : {0, 1}) {
    const double sign = side == 0 ? -1 : 1;
    Constants constants = fit.constants;
    if (bounds.logarithmic) {
      at[side] = sign * change;
      constants[i] *= std::exp(at[side]);
    } else {
      at[side] = sign * change;
      constants[i] = std::clamp(constants[i] + at[side] * (bounds.upper - bounds.lower),
                                bounds.lower, bounds.upper);
    }
    const auto threshold = threshold_of(fit, constants, c, step);
    if (!threshold) return std::nullopt;
    thresholds[side] = *threshold;
  }
  return std::log(thresholds[1] / thresholds[0]) / (at[1] - at[0]);
}

/// The loss with this parameter at a place within its bounds and the other free ones fitted.
double loss_with(const Fit& fit, const Search& search, std::size_t which, double share) {
  Parameterisation parameterisation{fit.interpretation, fit.free, fit.constants};
  Vector x = point_of(parameterisation, fit.constants);
  x[static_cast<Eigen::Index>(which)] = share;
  parameterisation.held = constants_at(parameterisation, x);
  parameterisation.free.erase(parameterisation.free.begin() + static_cast<std::ptrdiff_t>(which));
  return polish(parameterisation, search).loss;
}

Profile profile_of(const Fit& fit, const Search& search, std::size_t which) {
  const Parameterisation parameterisation{fit.interpretation, fit.free, fit.constants};
  const Unknown open = fit.free[which];
  const auto column = static_cast<Eigen::Index>(which);
  const Vector centre = point_of(parameterisation, fit.constants);
  const auto value_at = [&](double share) {
    Vector x = centre;
    x[column] = share;
    return constants_at(parameterisation, x)[static_cast<std::size_t>(open)];
  };
  Profile profile{open, value_at(centre[column]), 0, 0, true, true, {}};
  profile.points.emplace_back(profile.value, fit.loss);
  for (const double sign : {-1.0, 1.0}) {
    double reached = centre[column];
    bool ended = false;
    for (double distance = 1.0 / 512; distance <= 0.5 && !ended; distance *= 2) {
      const double share = std::clamp(centre[column] + sign * distance, 0.0, 1.0);
      if (share == reached) break;
      reached = share;
      const double found = loss_with(fit, search, which, share);
      profile.points.emplace_back(value_at(share), found);
      ended = found > fit.loss + 1;
    }
    (sign < 0 ? profile.lower : profile.upper) = value_at(reached);
    (sign < 0 ? profile.lower_open : profile.upper_open) = !ended;
  }
  std::sort(profile.points.begin(), profile.points.end());
  return profile;
}

}  // namespace

std::vector<CaseSensitivity> sensitivities(const Fit& fit, double step) {
  std::vector<CaseSensitivity> result;
  for (const Case& c : all_cases()) {
    if (!c.claim.threshold) continue;
    CaseSensitivity& row = result.emplace_back();
    row.case_id = c.id;
    for (const Unknown open : fit.free) row.slopes.push_back(slope_of(fit, c, open, step));
  }
  return result;
}

std::vector<Profile> profiles(const Fit& fit, const Search& search) {
  std::vector<Profile> result(fit.free.size());
  tbb::parallel_for(std::size_t{0}, result.size(),
                    [&](std::size_t i) { result[i] = profile_of(fit, search, i); });
  return result;
}

}  // namespace ricochet::studies::calibration
