#include "src/studies/trials/judgement.h"

#include "problems/carrier_track/questions/speed_range.h"

namespace ricochet::studies::trials {

using namespace carrier_track;

std::vector<calibration::CaseAppraisal> judged(const CountsOfCase& counts, double step) {
  std::vector<calibration::CaseAppraisal> cases;
  for (const Case& a_case : all_cases()) {
    const CountAt count = counts(a_case);
    SpeedScan scan = scan_speeds(count, step, fastest_speed);
    Score result = score(count, a_case.claim, scan, 1);
    cases.push_back({a_case, std::move(scan), std::move(result)});
  }
  return cases;
}

double differing_share(const SpeedScan& a, const SpeedScan& b) {
  std::size_t differing = 0;
  for (std::size_t k = 0; k < a.counts.size(); ++k) differing += a.counts[k] != b.counts[k] ? 1 : 0;
  return static_cast<double>(differing) / static_cast<double>(a.counts.size());
}

}  // namespace ricochet::studies::trials
