#include "src/studies/reproduction/data.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "problems/carrier_track/counting/staircase.h"
#include "problems/carrier_track/counting/threshold.h"
#include "ricochet/machine.h"
#include "src/analysis/comparison/group.h"

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

namespace {

constexpr double rpm = 30 / std::numbers::pi;  // of 1 rad/s

/// The smallest and the largest of some speeds.
struct Span {
  double least, most;
  bool one;  ///< whether they are the same
};
RICOCHET_FIELDS(Span, least, most, one);

/// Cases that differ only in their disturbance.
struct Machine {
  std::string cases;
  double restitution, friction;
  std::optional<Span> silent, speed;  ///< [rad/s], in the long run
  std::optional<Span> published;      ///< [rad/s], the paper's thresholds
};
RICOCHET_FIELDS(Machine, cases, restitution, friction, silent, speed, published);

struct ExampleSpeed {
  std::string case_;
  double speed, rpm;
};
RICOCHET_FIELDS(ExampleSpeed, case_, speed, rpm);

struct Speeds {
  std::optional<double> least, most, least_rpm, most_rpm;
  std::vector<Machine> machines;
  std::optional<ExampleSpeed> example;
};
RICOCHET_FIELDS(Speeds, least, most, least_rpm, most_rpm, machines, example);

std::optional<Span> span_of(const std::vector<double>& speeds) {
  if (speeds.empty()) return std::nullopt;
  const auto [least, most] = std::ranges::minmax(speeds);
  return Span{least, most, least == most};
}

}  // namespace

report::Json speed_data(const std::vector<CaseStudy>& cases) {
  struct SameMachine {
    std::string cases;
    std::vector<double> silent, quiet, published;
  };
  std::map<std::pair<double, double>, SameMachine> groups;
  std::vector<double> all;
  Speeds speeds;
  for (const CaseStudy& c : cases) {
    SameMachine& group = groups[{c.the_case.restitution, c.the_case.friction}];
    group.cases += (group.cases.empty() ? "" : ", ") + c.the_case.id;
    if (c.the_case.claim.threshold) group.published.push_back(*c.the_case.claim.threshold);
    if (c.borders.silent) group.silent.push_back(*c.borders.silent);
    if (!c.borders.quiet) continue;
    group.quiet.push_back(*c.borders.quiet);
    all.push_back(*c.borders.quiet);
    if (c.the_case.id == "C3") speeds.example = {"C3", all.back(), rpm * all.back()};
  }
  if (const auto span = span_of(all)) {
    speeds.least = span->least;
    speeds.most = span->most;
    speeds.least_rpm = rpm * span->least;
    speeds.most_rpm = rpm * span->most;
  }
  for (const auto& [constants, group] : groups) {
    speeds.machines.push_back({group.cases, constants.first, constants.second,
                               span_of(group.silent), span_of(group.quiet),
                               span_of(group.published)});
  }
  return speeds;
}

namespace {

/// Returns true if the step is at the threshold of the paper's rule, applied to the same counts.
bool is_near(const Step& step, const std::optional<double>& threshold) {
  return threshold && std::abs(std::log(step.omega / *threshold)) < std::log(1.1);
}

Json steps_of(const CaseStudy& c) {
  const auto main = c.staircase.main_step();
  Json steps = Json::array();
  for (const Step& step : c.staircase.steps) {
    steps.push_back({{"omega", step.omega},
                     {"below", step.below},
                     {"above", step.above},
                     {"significance", step.significance},
                     {"main", step.omega == main->omega}});
  }
  return {{"id", c.the_case.id},
          {"paper_threshold", c.the_case.claim.threshold},
          {"threshold", c.score.threshold},
          {"main", main ? Json(main->omega) : Json()},
          {"steps", std::move(steps)}};
}

}  // namespace

Json step_data(const std::vector<CaseStudy>& cases) {
  int thresholds = 0, with_step = 0, with_main_step = 0, without = 0;
  for (const CaseStudy& c : cases) {
    const auto& [steps, levels] = c.staircase;
    thresholds += c.score.threshold ? 1 : 0;
    without += steps.empty() ? 1 : 0;
    with_step += std::any_of(steps.begin(), steps.end(),
                             [&](const Step& step) { return is_near(step, c.score.threshold); });
    const auto main = c.staircase.main_step();
    with_main_step += main && is_near(*main, c.score.threshold) ? 1 : 0;
  }
  return {{"thresholds", thresholds},
          {"with_step", with_step},
          {"with_main_step", with_main_step},
          {"without", without},
          {"cases", report::list_of(cases, steps_of)}};
}

namespace {

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
RICOCHET_FIELDS(SharpnessRow, id, restitution, threshold, before, after, times, width,
                relative_width, persistence, is_step, is_climb, steady);

/// How the counts of the cases with one restitution rise.
struct Rises {
  double restitution;
  int all = 0, steps = 0, climbs = 0, neither = 0;
};
RICOCHET_FIELDS(Rises, restitution, all, steps, climbs, neither);

struct UnsteadyCase {
  std::string id;
};
RICOCHET_FIELDS(UnsteadyCase, id);

struct Sharpness {
  std::vector<SharpnessRow> cases;
  std::vector<Rises> rises;
  std::vector<UnsteadyCase> unsteady;
};
RICOCHET_FIELDS(Sharpness, cases, rises, unsteady);

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

report::Json comparison_data(const std::optional<StoredCampaign>& comparison) {
  using namespace comparison;
  if (!comparison) return {{"problems", 0}, {"groups", report::Json::array()}};
  const Campaign& campaign = comparison->campaign;
  const Comparison compared =
      comparison_of(campaign, cell_results(campaign, comparison->store), Conditions());
  const std::vector<Group> groups = groups_of(compared);
  return {{"problems", campaign.problems().size()},
          {"groups", group_data(compared, groups, ratings_of(compared, groups))}};
}

Json interpretation_data(const FittedInterpretation& interpretation) {
  Json constants = Json::array();
  for (const Unknown open : unknowns_of(interpretation.interpretation)) {
    const auto i = static_cast<std::size_t>(open);
    constants.push_back({{"name", std::string(unknown_parameters()[i].name)},
                         {"value", interpretation.constants[i]},
                         {"unit", std::string(unknown_parameters()[i].unit)},
                         {"fitted", contains(interpretation.free, open)}});
  }
  const auto* turns = std::get_if<Revolutions>(&interpretation.scene.window);
  const auto* time = std::get_if<Seconds>(&interpretation.scene.window);
  return {{"name", interpretation.name},
          {"description", interpretation.description},
          {"provenance", interpretation.provenance},
          {"projected", interpretation.interpretation.forcing == Centrifugal::projected},
          {"tension_constant", interpretation.interpretation.tension == Tension::constant},
          {"turns", turns != nullptr ? Json(turns->count) : Json()},
          {"seconds", time != nullptr ? Json(time->count) : Json()},
          {"fitted", interpretation.free.size()},
          {"constants", std::move(constants)}};
}

}  // namespace ricochet::studies::reproduction
