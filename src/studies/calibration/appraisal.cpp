#include "src/studies/calibration/appraisal.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

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

CaseAppraisal appraise(const Parameterisation& fit, const Case& a_case, double step) {
  const CountAt count = [&](double omega) { return exact_counts(fit, a_case, {omega}).front(); };
  const Interpretation& by = fit.interpretation;
  SpeedScan scan{step, {}};
  if (by.transition == Transition::plain && by.counted == Counted::from_start) {
    scan = scan_speeds(scene_of(a_case, by, fit.constants), step, fastest_speed);
  } else {
    std::vector<double> speeds(static_cast<std::size_t>(std::lround(fastest_speed / step)));
    for (std::size_t k = 0; k < speeds.size(); ++k) speeds[k] = scan.omega(k);
    scan.counts = exact_counts(fit, a_case, speeds);
  }
  Score result = score(count, a_case.claim, scan, 1);
  return {a_case, std::move(scan), std::move(result)};
}

double selection_criterion(double sum_of_squares, int errors, int constants) {
  const int p = constants + 1;  // plus one for the variance
  if (errors <= p + 1) return std::numeric_limits<double>::infinity();
  const double mean = std::max(1e-6, sum_of_squares / errors);
  return errors * std::log(mean) + 2.0 * p + 2.0 * p * (p + 1) / (errors - p - 1);
}

Appraisal appraise(const Parameterisation& fit, double step) {
  Appraisal result;
  const std::vector<Case> cases = all_cases();
  result.cases.resize(cases.size());
  tbb::parallel_for(std::size_t{0}, cases.size(),
                    [&](std::size_t i) { result.cases[i] = appraise(fit, cases[i], step); });
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

/// One side of a profile: the places of the parameter within its bounds that are tried.
struct Side {
  std::size_t which;   ///< of the free parameters
  double sign;         ///< of the direction
  double reached;      ///< the furthest place
  bool ended = false;  ///< the loss has risen, or the bound is reached
  bool rose = false;
};

}  // namespace

std::vector<Profile> profiles(const Fit& fit, const Search& search, Searches& searches) {
  const Vector centre = point_of(fit);
  const auto moved = [&](std::size_t which, double share) {
    Vector x = centre;
    x[static_cast<Eigen::Index>(which)] = share;
    return fit_at(fit, x);
  };
  std::vector<Side> sides;
  for (std::size_t i = 0; i < fit.free.size(); ++i) {
    const double place = centre[static_cast<Eigen::Index>(i)];
    sides.insert(sides.end(), {{i, -1, place}, {i, 1, place}});
  }
  for (double distance = 1.0 / 512; distance <= 0.5; distance *= 2) {
    std::vector<Side*> tried;
    std::vector<Fit> starts;
    for (Side& side : sides) {
      const double place = centre[static_cast<Eigen::Index>(side.which)];
      const double share = std::clamp(place + side.sign * distance, 0.0, 1.0);
      side.ended = side.ended || share == side.reached;
      if (side.ended) continue;
      side.reached = share;
      tried.push_back(&side);
      Fit& start = starts.emplace_back(Fit{moved(side.which, share)});
      start.free.erase(start.free.begin() + static_cast<std::ptrdiff_t>(side.which));
    }
    const std::vector<Fit> found = searches.polished(starts, search);
    for (std::size_t k = 0; k < tried.size(); ++k) {
      tried[k]->rose = found[k].loss > fit.loss + 1;
      tried[k]->ended = tried[k]->rose;
    }
  }
  std::vector<Profile> result;
  for (std::size_t i = 0; i < fit.free.size(); ++i) {
    const Side& below = sides[2 * i];
    const Side& above = sides[2 * i + 1];
    const auto value_at = [&](double share) {
      return moved(i, share).constants[static_cast<std::size_t>(fit.free[i])];
    };
    result.push_back({fit.free[i], value_at(centre[static_cast<Eigen::Index>(i)]),
                      value_at(below.reached), value_at(above.reached), !below.rose, !above.rose});
  }
  return result;
}

}  // namespace ricochet::studies::calibration
