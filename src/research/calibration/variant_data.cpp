#include <algorithm>
#include <cmath>

#include "problems/carrier_track/counting/staircase.h"
#include "ricochet/threshold.h"
#include "src/research/calibration/variant_results.h"
#include "src/research/solver_data.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;
using report::Json;
using report::list_of;

std::vector<CaseAppraisal> claimed(std::vector<CaseAppraisal> cases) {
  std::erase_if(cases, [](const CaseAppraisal& c) { return !c.the_case.claim.threshold; });
  return cases;
}

/// ln(threshold / paper) of each case with a claim; null if there is no threshold.
Json errors_of(const Appraisal& appraisal) {
  return list_of(claimed(appraisal.cases), [](const CaseAppraisal& c) -> Json {
    if (!c.score.threshold) return nullptr;
    return std::log(*c.score.threshold / *c.the_case.claim.threshold);
  });
}

Json row_of(const VariantResults& results, const JudgedVariant& judged, bool is_baseline) {
  const double loss = judged.best().loss;
  const JudgedVariant& baseline = results.baseline_of(judged);
  const bool nearer = results.is_nearer(judged);
  Json row = {
      {"name", judged.variant.name},
      {"description", judged.variant.description},
      {"base", name_of(judged.variant.base)},
      {"constants", judged.variant.free.size() + judged.variant.own.size()},
      {"evaluations", judged.evaluations},
      {"losses", list_of(judged.fits, &Fit::loss)},
      {"loss", loss},
      {"baseline", baseline.variant.name},
      {"base_loss", baseline.best().loss},
      {"gain", is_baseline ? Json() : Json(baseline.best().loss - loss)},
      {"nearer", is_baseline ? Json() : Json(nearer)},
      {"undecided", !is_baseline && !nearer && loss < baseline.worst()},
      {"errors", errors_of(judged.appraisal)},
      {"claims", list_of(claimed(judged.appraisal.cases), [](const CaseAppraisal& c) -> Json {
         return {{"threshold", c.score.threshold}, {"count", c.score.quiet_count}};
       })}};
  row.update(Json(judged.appraisal));
  return row;
}

/// Adds the variant's own parameters, with the values of its best fit.
void add_own_constants(Json& rows, const JudgedVariant& judged) {
  for (std::size_t i = 0; i < judged.variant.own.size(); ++i) {
    const UnknownParameter& c = judged.variant.own[i];
    rows.push_back({{"variant", judged.variant.name},
                    {"constant", c.name},
                    {"value", judged.best().own[i]},
                    {"unit", c.unit},
                    {"lower", c.lower},
                    {"upper", c.upper},
                    {"why", c.why}});
  }
}

/// A row for each disturbed case: its threshold for every draw.
Json draws_of(const VariantResults& results) {
  Json rows = Json::array();
  const std::vector<Case> cases = disturbed_cases();
  for (std::size_t i = 0; i < cases.size(); ++i) {
    std::vector<double> found;
    for (const DrawnThresholds& draw : results.draws) {
      if (draw.thresholds[i]) found.push_back(*draw.thresholds[i]);
    }
    const auto [least, most] = std::ranges::minmax_element(found);
    rows.push_back({{"case", cases[i].id},
                    {"paper", cases[i].claim.threshold},
                    {"thresholds", list_of(results.draws,
                                           [i](const DrawnThresholds& draw) -> Json {
                                             return {{"threshold", draw.thresholds[i]}};
                                           })},
                    {"scatter", found.empty() ? Json() : Json(std::log(*most / *least))}});
  }
  return rows;
}

/// The share of speeds at which two counts of the same case differ.
double differing_share(const CaseAppraisal& a, const CaseAppraisal& b) {
  std::size_t differing = 0;
  for (std::size_t k = 0; k < a.scan.counts.size(); ++k) {
    differing += a.scan.counts[k] != b.scan.counts[k] ? 1 : 0;
  }
  return static_cast<double>(differing) / static_cast<double>(a.scan.counts.size());
}

Json staircase_of(const char* name, const SpeedScan& scan) {
  Json points = Json::array();
  for (std::size_t k = 0; k < scan.counts.size(); ++k) {
    points.push_back({{"speed", scan.omega(k)}, {"count", scan.counts[k]}});
  }
  return {{"name", name}, {"points", std::move(points)}};
}

Json integration_of(const SameConstants& same) {
  Json rows = Json::array();
  double differs = 0, exact_differs = 0, moves = 0;
  const auto usual = claimed(same.usual), tight = claimed(same.tight), exact = claimed(same.exact);
  const auto cases = static_cast<double>(usual.size());
  for (std::size_t i = 0; i < usual.size(); ++i) {
    const double share = differing_share(usual[i], tight[i]);
    const double exact_share = differing_share(exact[i], tight[i]);
    differs += share / cases;
    exact_differs += exact_share / cases;
    const auto& one = usual[i].score.threshold;
    const auto& other = tight[i].score.threshold;
    if (one && other) moves = std::max(moves, std::abs(std::log(*one / *other)));
    rows.push_back({{"case", usual[i].the_case.id},
                    {"paper", usual[i].the_case.claim.threshold},
                    {"usual", one},
                    {"tight", other},
                    {"exact", exact[i].score.threshold},
                    {"differs", share},
                    {"exact_differs", exact_share}});
  }
  return {{"fitted", same.fitted},
          {"stiffness", same.stiffness},
          {"rows", std::move(rows)},
          {"differs", differs},
          {"exact_differs", exact_differs},
          {"moves", moves},
          {"shown", usual[1].the_case.id},
          {"staircases",
           {staircase_of("default tolerances", usual[1].scan),
            staircase_of("tight tolerances", tight[1].scan),
            staircase_of("exact events", exact[1].scan)}}};
}

Json plan_of(const VariantPlan& plan) {
  return {{"global", solver_data(plan.search.global)},
          {"local", solver_data(plan.search.local)},
          {"evaluations", plan.search.evaluations},
          {"brief_evaluations", plan.brief_evaluations},
          {"seeds", plan.seeds},
          {"step", plan.step},
          {"brief_step", plan.brief_step}};
}

Json rows_where(const Json& rows, const char* what) {
  Json found = Json::array();
  for (const Json& row : rows) {
    if (row[what] == true) found.push_back({{"name", row["name"]}, {"gain", row["gain"]}});
  }
  return found;
}

}  // namespace

Json data_of(const VariantResults& results) {
  Json rows = Json::array(), own = Json::array();
  double widest_spread = 0;
  for (const auto* list : {&results.baselines, &results.variants}) {
    for (const JudgedVariant& each : *list) {
      rows.push_back(row_of(results, each, list == &results.baselines));
      add_own_constants(own, each);
      widest_spread = std::max(widest_spread, each.worst() - each.best().loss);
    }
  }
  const auto loss = [](const JudgedVariant& each) { return each.best().loss; };
  std::vector<JudgedVariant> as_long = results.baselines;
  std::erase_if(as_long, [](const JudgedVariant& each) { return each.variant.brief; });
  const JudgedVariant& baseline = *std::ranges::min_element(as_long, {}, loss);
  const JudgedVariant& nearest = results.variants.front();
  const JudgedVariant& careless = results.variant("ode45-default");
  const Json nearer = rows_where(rows, "nearer"), undecided = rows_where(rows, "undecided");
  const auto count_of = [](const Json& list) { return list.empty() ? Json() : Json(list.size()); };
  return {{"plan", plan_of(results.plan)},
          {"rows", rows},
          {"cases", list_of(claimed(results.baselines.front().appraisal.cases),
                            [](const CaseAppraisal& c) { return c.the_case.id; })},
          {"tried", results.variants.size()},
          {"nearer", nearer},
          {"nearer_count", nearer.size()},
          {"undecided", undecided},
          {"undecided_count", count_of(undecided)},
          {"careless_loss", loss(careless)},
          {"tight_loss", loss(results.variant("ode45-tight"))},
          {"hard_loss", loss(results.baseline_of(careless))},
          {"best_baseline", {{"name", baseline.variant.name}, {"loss", loss(baseline)}}},
          {"best_variant", {{"name", nearest.variant.name}, {"loss", loss(nearest)}}},
          {"widest_spread", widest_spread},
          {"own", std::move(own)},
          {"drawn", results.drawn},
          {"draw_seeds", list_of(results.draws,
                                 [](const DrawnThresholds& d) -> Json {
                                   return {{"draw", d.draw}, {"loss", d.loss}};
                                 })},
          {"draws", draws_of(results)},
          {"integrations", list_of(results.integrations, integration_of)}};
}

}  // namespace ricochet::studies::calibration
