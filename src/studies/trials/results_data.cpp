#include <algorithm>
#include <cmath>

#include "src/studies/trials/results.h"

namespace ricochet::studies::trials {
namespace {

using namespace carrier_track;
using calibration::CaseAppraisal;
using report::Json;
using report::list_of;

/// ln(threshold / paper); nothing where either has none.
Json error_of(const std::optional<double>& threshold, const Case& the_case) {
  if (!threshold || !the_case.claim.threshold) return nullptr;
  return std::log(*threshold / *the_case.claim.threshold);
}

std::vector<CaseAppraisal> claimed(std::vector<CaseAppraisal> cases) {
  std::erase_if(cases, [](const CaseAppraisal& c) { return !c.the_case.claim.threshold; });
  return cases;
}

Json own_constants_of(const JudgedTrial& judged) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < judged.trial.own.size(); ++i) {
    const OpenConstant& c = judged.trial.own[i];
    rows.push_back({{"trial", judged.trial.name},
                    {"constant", c.name},
                    {"value", judged.best().constants.own[i]},
                    {"unit", c.unit},
                    {"lower", c.lower},
                    {"upper", c.upper},
                    {"why", c.why}});
  }
  return rows;
}

Json row_of(const Results& results, const JudgedTrial& judged, bool is_baseline) {
  const calibration::Appraisal& a = judged.appraisal;
  const JudgedTrial& baseline = results.baseline_of(judged);
  const auto cases = claimed(a.cases);
  return {{"name", judged.trial.name},
          {"description", judged.trial.description},
          {"base", name_of(judged.trial.base)},
          {"is_baseline", is_baseline},
          {"constants", judged.trial.freed.size() + judged.trial.own.size()},
          {"evaluations", judged.evaluations},
          {"misfits", list_of(judged.fits, &TrialFit::misfit)},
          {"misfit", judged.best().misfit},
          {"spread", judged.worst() - judged.best().misfit},
          {"baseline", baseline.trial.name},
          {"base_misfit", baseline.best().misfit},
          {"gain", is_baseline ? Json() : Json(baseline.best().misfit - judged.best().misfit)},
          {"nearer", is_baseline ? Json() : Json(results.is_nearer(judged))},
          {"undecided",
           !is_baseline && !results.is_nearer(judged) && judged.best().misfit < baseline.worst()},
          {"threshold_error", a.threshold_error},
          {"within", a.within},
          {"exact_counts", a.exact_counts},
          {"purity", a.purity},
          {"misclassified", a.misclassified},
          {"loudness", a.loudness},
          {"right_examples", a.right_examples},
          {"quiet_share", a.quiet_share},
          {"criterion", a.criterion},
          {"claims",
           list_of(cases,
                   [](const CaseAppraisal& c) -> Json {
                     return {{"threshold", c.score.threshold}, {"count", c.score.quiet_count}};
                   })},
          {"errors", list_of(cases, [](const CaseAppraisal& c) {
             return error_of(c.score.threshold, c.the_case);
           })}};
}

Json paper_row() {
  Json claims = Json::array();
  for (const Case& c : all_cases()) {
    if (!c.claim.threshold) continue;
    claims.push_back({{"threshold", c.claim.threshold}, {"count", c.claim.quiet_count}});
  }
  return {{"name", "the paper"}, {"claims", std::move(claims)}};
}

/// A row a disturbed case: its threshold by every draw.
Json draws_of(const Results& results) {
  Json rows = Json::array();
  const std::vector<Case> cases = disturbed_cases();
  for (std::size_t i = 0; i < cases.size(); ++i) {
    double least = INFINITY, most = 0;
    Json thresholds = Json::array();
    for (const DrawnThresholds& draw : results.draws) {
      thresholds.push_back({{"case", cases[i].id}, {"threshold", draw.thresholds[i]}});
      if (!draw.thresholds[i]) continue;
      least = std::min(least, *draw.thresholds[i]);
      most = std::max(most, *draw.thresholds[i]);
    }
    rows.push_back({{"case", cases[i].id},
                    {"paper", cases[i].claim.threshold},
                    {"thresholds", std::move(thresholds)},
                    {"least", most > 0 ? Json(least) : Json()},
                    {"most", most > 0 ? Json(most) : Json()},
                    {"scatter", most > 0 ? Json(std::log(most / least)) : Json()}});
  }
  return rows;
}

Json staircase_of(const SpeedScan& scan) {
  Json points = Json::array();
  for (std::size_t k = 0; k < scan.counts.size(); ++k) {
    points.push_back({{"speed", scan.omega(k)}, {"count", scan.counts[k]}});
  }
  return points;
}

Json integration_of(const SameConstants& same) {
  Json rows = Json::array();
  double differs = 0, exact_differs = 0, moves = 0;
  const auto usual = claimed(same.usual), tight = claimed(same.tight), exact = claimed(same.exact);
  const auto cases = static_cast<double>(usual.size());
  for (std::size_t i = 0; i < usual.size(); ++i) {
    const double share = differing_share(usual[i].scan, tight[i].scan);
    const double exact_share = differing_share(exact[i].scan, tight[i].scan);
    differs += share / cases;
    exact_differs += exact_share / cases;
    const auto& one = usual[i].score.threshold;
    const auto& other = tight[i].score.threshold;
    if (one && other) moves = std::max(moves, std::abs(std::log(*one / *other)));
    rows.push_back({{"case", usual[i].the_case.id},
                    {"paper", usual[i].the_case.claim.threshold},
                    {"usual", usual[i].score.threshold},
                    {"tight", tight[i].score.threshold},
                    {"exact", exact[i].score.threshold},
                    {"differs", share},
                    {"exact_differs", exact_share}});
  }
  return {{"fitted", same.fitted},
          {"stiffness", same.constants.own.at(0)},
          {"rows", std::move(rows)},
          {"differs", differs},
          {"exact_differs", exact_differs},
          {"moves", moves},
          {"staircases",
           {{{"name", "default tolerances"}, {"points", staircase_of(usual[1].scan)}},
            {{"name", "tight tolerances"}, {"points", staircase_of(tight[1].scan)}},
            {{"name", "exact events"}, {"points", staircase_of(exact[1].scan)}}}},
          {"shown", usual[1].the_case.id}};
}

/// What the careless integration and the tight one end at, and hard walls in the same way.
Json carelessness_of(const Results& results) {
  const JudgedTrial& careless = results.trial("ode45-default");
  return {{"careless", careless.best().misfit},
          {"tight", results.trial("ode45-tight").best().misfit},
          {"hard", results.baseline_of(careless).best().misfit}};
}

Json plan_of(const TrialPlan& plan) {
  const auto of = [](const Solver& solver) {
    return Json{{"name", solver.name}, {"version", solver.version}};
  };
  return {{"global", of(plan.search.global)},
          {"local", of(plan.search.local)},
          {"evaluations", plan.search.evaluations},
          {"brief_evaluations", plan.brief_evaluations},
          {"seeds", plan.seeds},
          {"step", plan.step},
          {"brief_step", plan.brief_step}};
}

}  // namespace

Json data_of(const Results& results) {
  Json baselines = Json::array(), trials = Json::array(), own = Json::array();
  for (const JudgedTrial& each : results.baselines) {
    baselines.push_back(row_of(results, each, true));
  }
  for (const JudgedTrial& each : results.trials) {
    trials.push_back(row_of(results, each, false));
    for (Json& row : own_constants_of(each)) own.push_back(std::move(row));
  }
  const auto lower = [](const Json& a, const Json& b) { return a["misfit"] < b["misfit"]; };
  const auto less_gain = [](const Json& a, const Json& b) { return a["gain"] < b["gain"]; };
  std::stable_sort(trials.begin(), trials.end(), lower);
  Json rows = baselines, as_long = Json::array();
  for (const Json& row : baselines) {
    if (row["evaluations"] == results.plan.search.evaluations) as_long.push_back(row);
  }
  rows.insert(rows.end(), trials.begin(), trials.end());
  Json claims = Json::array({paper_row()});
  for (Json& row : rows) {
    claims.push_back({{"name", row["name"]}, {"claims", row["claims"]}});
    row.erase("claims");
  }
  Json nearer = Json::array(), undecided = Json::array();
  double widest = 0;
  for (const Json& row : rows) {
    widest = std::max(widest, row["spread"].get<double>());
    if (row["nearer"] == true) nearer.push_back(row);
    if (row["undecided"] == true) undecided.push_back(row);
  }
  std::vector<Case> cases = all_cases();
  std::erase_if(cases, [](const Case& c) { return !c.claim.threshold; });
  return {{"plan", plan_of(results.plan)},
          {"rows", rows},
          {"claims", std::move(claims)},
          {"cases", list_of(cases, &Case::id)},
          {"tried", trials.size()},
          {"nearer", nearer},
          {"nearer_count", nearer.size()},
          {"undecided", undecided},
          {"undecided_count", undecided.empty() ? Json() : Json(undecided.size())},
          {"carelessness", carelessness_of(results)},
          {"best_baseline", *std::min_element(as_long.begin(), as_long.end(), lower)},
          {"best_trial", trials.front()},
          {"most_gained", *std::max_element(trials.begin(), trials.end(), less_gain)},
          {"widest_spread", widest},
          {"own", std::move(own)},
          {"drawn", results.drawn},
          {"draw_seeds", list_of(results.draws,
                                 [](const DrawnThresholds& d) -> Json {
                                   return {{"draw", d.draw}, {"misfit", d.misfit}};
                                 })},
          {"draws", draws_of(results)},
          {"integrations", list_of(results.integrations, integration_of)}};
}

}  // namespace ricochet::studies::trials
