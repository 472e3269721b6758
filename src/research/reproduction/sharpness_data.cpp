#include <algorithm>
#include <optional>

#include "problems/carrier_track/counting/step_sharpness.h"
#include "problems/carrier_track/counting/threshold.h"
#include "src/research/reproduction/data.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;

std::optional<StepSharpness> sharpness_of(const CaseStudy& c, double reach) {
  if (!c.score.threshold) return std::nullopt;
  return step_sharpness(c.scan, *c.score.threshold, quiet_limit(c.score.quiet_count), reach);
}

constexpr double usual_reach = 1.5;

/// A case; the later fields are missing if it has no threshold.
struct SharpnessRow {
  std::string id;
  double restitution;
  std::optional<double> threshold;
  std::optional<int> before = {}, after = {};  ///< counts
  std::optional<double> times = {}, width = {}, relative_width = {};
  std::optional<double> persistence = {};
  std::optional<bool> is_step = {}, is_climb = {};
  std::optional<bool> steady = {};  ///< true if other ranges give the same answer
};
RICOCHET_WRITTEN_AS_JSON(SharpnessRow, id, restitution, threshold, before, after, times, width,
                         relative_width, persistence, is_step, is_climb, steady);

/// How the counts of the cases with one restitution rise.
struct Rises {
  double restitution;
  int all = 0, steps = 0, climbs = 0, neither = 0;
};
RICOCHET_WRITTEN_AS_JSON(Rises, restitution, all, steps, climbs, neither);

struct UnsteadyCase {
  std::string id;
};
RICOCHET_WRITTEN_AS_JSON(UnsteadyCase, id);

struct Sharpness {
  std::vector<SharpnessRow> cases;
  std::vector<Rises> rises;
  std::vector<UnsteadyCase> unsteady;
};
RICOCHET_WRITTEN_AS_JSON(Sharpness, cases, rises, unsteady);

SharpnessRow sharpness_row(const CaseStudy& c) {
  SharpnessRow row{c.the_case.id, c.the_case.restitution, c.score.threshold};
  const auto found = sharpness_of(c, usual_reach);
  if (!found) return row;
  row.before = found->before;
  row.after = found->after;
  row.times = static_cast<double>(found->after) / std::max(1, found->before);
  row.width = found->width;
  row.relative_width = found->width / found->threshold;
  row.persistence = found->persistence;
  row.is_step = found->rise == Rise::step;
  row.is_climb = found->rise == Rise::climb;
  row.steady = true;
  for (const double reach : {1.25, 2.0}) {
    const auto other = sharpness_of(c, reach);
    row.steady = *row.steady && other && other->rise == found->rise;
  }
  return row;
}

Rises rises_of(double restitution, const std::vector<SharpnessRow>& rows) {
  Rises rises{restitution};
  for (const SharpnessRow& row : rows) {
    if (row.restitution != restitution) continue;
    ++rises.all;
    ++(row.is_step.value_or(false)    ? rises.steps
       : row.is_climb.value_or(false) ? rises.climbs
                                      : rises.neither);
  }
  return rises;
}

}  // namespace

report::Json sharpness_data(const std::vector<CaseStudy>& cases) {
  Sharpness data;
  for (const CaseStudy& c : cases) {
    const SharpnessRow& row = data.cases.emplace_back(sharpness_row(c));
    if (!row.steady.value_or(true)) data.unsteady.push_back({row.id});
  }
  data.rises = {rises_of(0.1, data.cases), rises_of(0.9, data.cases)};
  return data;
}

}  // namespace ricochet::studies::reproduction
