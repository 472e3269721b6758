#include "src/studies/calibration/appraisal.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/machine.h"

namespace ricochet::studies::calibration {

namespace {

using namespace carrier_track;

double square(double x) {
  return x * x;
}

}  // namespace

CountAt counts_of(const Case& a_case, const Interpretation& interpretation,
                  const Constants& constants) {
  return [&, scene = scene_of(a_case, interpretation, constants)](double omega) {
    return static_cast<int>(objective(scene_at(scene, interpretation, constants, omega), 0.0));
  };
}

SpeedScan scan_of(const Case& a_case, const Interpretation& interpretation,
                  const Constants& constants, double step) {
  if (interpretation.transition == Transition::plain) {
    return scan_speeds(scene_of(a_case, interpretation, constants), step, fastest_speed);
  }
  return scan_speeds(counts_of(a_case, interpretation, constants), step, fastest_speed);
}

double selection_criterion(double sum_of_squares, int errors, int constants) {
  const int p = constants + 1;  // plus one for the variance
  if (errors <= p + 1) return std::numeric_limits<double>::infinity();
  const double mean = std::max(1e-6, sum_of_squares / errors);
  return errors * std::log(mean) + 2.0 * p + 2.0 * p * (p + 1) / (errors - p - 1);
}

namespace {

/// Evaluates all cases by evenly spaced speeds, in parallel.
std::vector<CaseAppraisal> judged_cases(const Fit& fit, double step) {
  const std::vector<Case> cases = all_cases();
  std::vector<CaseAppraisal> judged(cases.size());
  tbb::parallel_for(std::size_t{0}, cases.size(), [&](std::size_t i) {
    SpeedScan scan = scan_of(cases[i], fit.interpretation, fit.constants, step);
    Score result =
        score(counts_of(cases[i], fit.interpretation, fit.constants), cases[i].claim, scan, 1);
    judged[i] = {cases[i], std::move(scan), std::move(result)};
  });
  return judged;
}

}  // namespace

Appraisal appraise(const Fit& fit, double step) {
  Appraisal result;
  result.cases = judged_cases(fit, step);
  double squares = 0;
  double count_squares = 0;
  int thresholds = 0;
  double quiet_limit_of_c4 = 0;
  result.loudness = std::numeric_limits<double>::infinity();
  for (const CaseAppraisal& c : result.cases) {
    const Score& s = c.score;
    const Claim& claim = c.the_case.claim;
    if (c.the_case.id == "C4") quiet_limit_of_c4 = quiet_limit(s.quiet_count);
    if (c.the_case.id == "C11") {
      const auto& counts = c.scan.counts;
      const auto quiet = std::count_if(counts.begin(), counts.end(),
                                       [&](int count) { return count <= quiet_limit_of_c4; });
      result.quiet_share = static_cast<double>(quiet) / static_cast<double>(counts.size());
    }
    if (!claim.threshold) continue;
    ++thresholds;
    // Without a threshold, the case counts as if it were at the lowest or at the highest speed.
    const double end =
        c.scan.counts.front() > quiet_limit(s.quiet_count) ? c.scan.step : fastest_speed;
    const double error = std::log(s.threshold.value_or(end) / *claim.threshold);
    squares += square(error);
    result.within += std::abs(error) <= std::log(1.05) ? 1 : 0;
    result.exact_counts += s.quiet_count == *claim.quiet_count ? 1 : 0;
    count_squares += square(std::log(std::max(s.quiet_count, 1) / double(*claim.quiet_count)));
    result.purity = std::min(result.purity, s.purity.value_or(0));
    result.misclassified = std::max(result.misclassified, s.misclassified);
    result.loudness = std::min(result.loudness, s.loudness.value_or(0));
    for (const Example& e : s.examples) result.right_examples += e.right ? 1 : 0;
  }
  result.threshold_error = std::sqrt(squares / thresholds);
  result.criterion = selection_criterion(squares + count_squares, 2 * thresholds,
                                         static_cast<int>(fit.free.size()));
  return result;
}

namespace {

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
  for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
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
