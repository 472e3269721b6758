#include "src/research/calibration/appraisal.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/problems/speed_range.h"
#include "ricochet/threshold.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

/// A case by its counts, stored by a scan at evenly spaced speeds.
struct ScannedCase {
  CountAt count;
  SpeedScan scan;
};

template <class Scanned>
std::vector<CaseAppraisal> judged_cases(const Scanned& scanned) {
  const std::vector<Case> cases = all_cases();
  std::vector<CaseAppraisal> judged(cases.size());
  tbb::parallel_for(std::size_t{0}, cases.size(), [&](std::size_t i) {
    auto [count, scan] = scanned(cases[i]);
    Score result = score(count, cases[i].claim, scan, 1);
    judged[i] = {cases[i], std::move(scan), std::move(result)};
  });
  return judged;
}

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

std::vector<CaseAppraisal> judged(const CountsOfCase& counts, double step) {
  return judged_cases([&](const Case& a_case) {
    CountAt count = counts(a_case);
    SpeedScan scan = scan_speeds(count, step, fastest_speed);
    return ScannedCase{std::move(count), std::move(scan)};
  });
}

Appraisal appraise(const Fit& fit, double step) {
  const auto scanned = [&](const Case& a_case) {
    return ScannedCase{counts_of(a_case, fit.interpretation, fit.constants),
                       scan_of(a_case, fit.interpretation, fit.constants, step)};
  };
  return summed_up(judged_cases(scanned), static_cast<int>(fit.free.size()));
}

Appraisal summed_up(std::vector<CaseAppraisal> cases, int constants) {
  Appraisal result;
  result.cases = std::move(cases);
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
    result.worst_threshold = std::max(result.worst_threshold, std::abs(error));
    result.within += std::abs(error) <= std::log(1.05) ? 1 : 0;
    result.exact_counts += s.quiet_count == *claim.quiet_count ? 1 : 0;
    count_squares += square(std::log(std::max(s.quiet_count, 1) / double(*claim.quiet_count)));
    result.purity = std::min(result.purity, s.purity.value_or(0));
    result.misclassified = std::max(result.misclassified, s.misclassified);
    result.loudness = std::min(result.loudness, s.loudness.value_or(0));
    for (const Example& e : s.examples) result.right_examples += e.right ? 1 : 0;
  }
  result.threshold_error = std::sqrt(squares / thresholds);
  result.criterion = selection_criterion(squares + count_squares, 2 * thresholds, constants);
  return result;
}

}  // namespace ricochet::studies::calibration
