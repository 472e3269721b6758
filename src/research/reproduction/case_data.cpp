#include <algorithm>
#include <cmath>

#include "problems/carrier_track/counting/threshold.h"
#include "ricochet/threshold.h"
#include "src/research/reproduction/data.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;
using report::Json;

Json relative_error(const std::optional<double>& computed, const std::optional<double>& paper) {
  return computed && paper ? Json(*computed / *paper - 1) : Json();
}

/// The count over the speeds, with a row only where it jumps.
Json curve_of(const CaseStudy& c) {
  const SpeedScan scan = c.scan.step < 0.01 ? thinned(c.scan, 10) : c.scan;
  Json staircase = Json::array();
  for (std::size_t k = 0; k < scan.counts.size(); ++k) {
    const bool last = k + 1 == scan.counts.size();
    if (k > 0 && !last && scan.counts[k] == scan.counts[k - 1]) continue;
    staircase.push_back({{"speed", scan.omega(k)}, {"count", scan.counts[k]}});
  }
  return {{"quiet_limit", quiet_limit(c.score.quiet_count)},
          {"top", 1.1 * *std::max_element(scan.counts.begin(), scan.counts.end())},
          {"staircase", std::move(staircase)}};
}

}  // namespace

Json case_data(const std::vector<CaseStudy>& cases) {
  Json by_id = Json::object();
  for (const CaseStudy& c : cases) {
    const Case& it = c.the_case;
    const Score& s = c.score;
    by_id[it.id] = {{"id", it.id},
                    {"restitution", it.restitution},
                    {"friction", it.friction},
                    {"disturbance", it.disturbance},
                    {"paper_threshold", it.claim.threshold},
                    {"silent_up_to", c.borders.silent},
                    {"quiet_up_to", c.borders.quiet},
                    {"quiet_error", relative_error(c.borders.quiet, it.claim.threshold)},
                    {"threshold", s.threshold},
                    {"threshold_error", relative_error(s.threshold, it.claim.threshold)},
                    {"first_loud", s.first_loud},
                    {"paper_quiet_count", it.claim.quiet_count},
                    {"quiet_count", s.quiet_count},
                    {"quiet_count_error", relative_error(s.quiet_count, it.claim.quiet_count)},
                    {"misclassified", s.misclassified},
                    {"purity", s.purity},
                    {"loudness", s.loudness},
                    {"loud", s.loudness && *s.loudness >= 1.5}};
  }
  return by_id;
}

Json threshold_data(const std::vector<CaseStudy>& cases) {
  Json examples = Json::array();
  Json wrong = Json::array();
  for (const CaseStudy& c : cases) {
    if (!c.the_case.claim.figure) continue;
    Json row = {{"figure", c.the_case.claim.figure->number}, {"id", c.the_case.id}};
    for (const Example& e : c.score.examples) {
      const char* side = e.loud ? "loud" : "quiet";
      row[side] = {{"omega", e.omega}, {"count", e.count}, {"right", e.right}};
      if (e.right) continue;
      wrong.push_back(
          {{"id", c.the_case.id}, {"omega", e.omega}, {"count", e.count}, {"shown", side}});
    }
    row["quiet_up_to"] = std::floor(quiet_limit(c.score.quiet_count));
    examples.push_back(std::move(row));
  }
  return {{"examples", std::move(examples)}, {"wrong", std::move(wrong)}};
}

Json curve_data(const std::vector<CaseStudy>& cases) {
  Json by_id = Json::object();
  for (const CaseStudy& c : cases) by_id[c.the_case.id] = curve_of(c);
  return by_id;
}

}  // namespace ricochet::studies::reproduction
