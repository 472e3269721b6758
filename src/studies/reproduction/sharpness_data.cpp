#include <algorithm>
#include <map>
#include <optional>

#include "problems/carrier_track/counting/step_sharpness.h"
#include "src/studies/reproduction/data.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;
using report::Json;

std::optional<StepSharpness> sharpness_of(const CaseStudy& c, double reach) {
  if (!c.score.threshold) return std::nullopt;
  return step_sharpness(c.scan, *c.score.threshold, quiet_limit(c.score.quiet_count), reach);
}

constexpr double usual_reach = 1.5;

/// Nulls where there is no threshold.
Json sharpness_row(const CaseStudy& c) {
  Json row = {{"id", c.the_case.id},
              {"restitution", c.the_case.restitution},
              {"threshold", c.score.threshold}};
  const auto found = sharpness_of(c, usual_reach);
  for (const char* key : {"before", "after", "times", "width", "relative_width", "persistence",
                          "is_step", "is_climb", "steady"}) {
    row[key] = nullptr;
  }
  if (!found) return row;
  bool steady = true;
  for (const double reach : {1.25, 2.0}) {
    const auto other = sharpness_of(c, reach);
    steady = steady && other && other->rise == found->rise;
  }
  row.update(Json{{"before", found->before},
                  {"after", found->after},
                  {"times", static_cast<double>(found->after) / std::max(1, found->before)},
                  {"width", found->width},
                  {"relative_width", found->width / found->threshold},
                  {"persistence", found->persistence},
                  {"is_step", found->rise == Rise::step},
                  {"is_climb", found->rise == Rise::climb},
                  {"steady", steady}});
  return row;
}

/// How the cases of a restitution rise.
Json rises_of(double restitution, const std::vector<CaseStudy>& cases) {
  std::map<Rise, int> rises;
  int missing = 0;
  for (const CaseStudy& c : cases) {
    if (c.the_case.restitution != restitution) continue;
    const auto found = sharpness_of(c, usual_reach);
    found ? ++rises[found->rise] : ++missing;
  }
  return {{"restitution", restitution},
          {"all", rises[Rise::step] + rises[Rise::climb] + rises[Rise::none] + missing},
          {"steps", rises[Rise::step]},
          {"climbs", rises[Rise::climb]},
          {"neither", rises[Rise::none] + missing}};
}

}  // namespace

Json sharpness_data(const std::vector<CaseStudy>& cases) {
  Json unsteady = Json::array();
  Json rows = report::list_of(cases, sharpness_row);
  for (const Json& row : rows) {
    if (row["steady"] == false) unsteady.push_back({{"id", row["id"]}});
  }
  return {{"cases", std::move(rows)},
          {"rises", {rises_of(0.1, cases), rises_of(0.9, cases)}},
          {"unsteady", std::move(unsteady)}};
}

}  // namespace ricochet::studies::reproduction
