#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "src/studies/calibration/results.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;
using report::Json;
using report::list_of;

const OpenConstant& constant_of(Open open) {
  return open_constants()[static_cast<std::size_t>(open)];
}

/// Name of an open constant as people read it: "centrifugal mass radius".
std::string words_of(Open constant) {
  std::string words(constant_of(constant).name);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

/// "projected-constant-revolutions (5)": with the number of its free constants.
std::string words_of(const Freedom& freedom) {
  return fmt::format("{} ({})", name_of(freedom.reading), freedom.freed.size());
}

Json data_of(const RankedFit& r) {
  const Appraisal& a = r.appraisal;
  return {{"reading", name_of(r.fit.reading)},
          {"constants", r.fit.freed.size()},
          {"misfit", r.fit.misfit},
          {"threshold_error", a.threshold_error},
          {"within", a.within},
          {"exact_counts", a.exact_counts},
          {"purity", a.purity},
          {"misclassified", a.misclassified},
          {"loudness", a.loudness},
          {"right_examples", a.right_examples},
          {"quiet_share", a.quiet_share},
          {"criterion", a.criterion}};
}

/// The best reading for every answer to every question.
Json answers_of(const std::vector<RankedFit>& readings) {
  std::vector<std::string> questions;
  std::map<std::string, std::map<std::string, const RankedFit*>> best;
  for (const RankedFit& r : readings) {
    for (const auto& [question, answer] : carrier_track::answers_of(r.fit.reading)) {
      if (!best.contains(question)) questions.push_back(question);
      best[question].try_emplace(answer, &r);  // by rising misfit: the first is the best
    }
  }
  Json rows = Json::array();
  for (const std::string& question : questions) {
    for (const auto& [answer, r] : best[question]) {
      Json row = {{"question", question},
                  {"answer", answer},
                  {"best", r == &readings.front() ? Json(true) : Json()}};
      row.update(data_of(*r));
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

Json rankings_of(const Results& results) {
  Json searches = Json::array();
  Json rows =
      Json::array({{{"reading", "rank correlation"}, {"own", nullptr}, {"others", Json::array()}}});
  for (const Ranking& r : results.rankings) {
    searches.push_back({{"solver", r.search.global.name}, {"seed", r.search.seed}});
    rows[0]["others"].push_back({{"correlation", r.rank_correlation}, {"misfit", nullptr}});
  }
  for (const RankedFit& own : results.readings) {
    Json others = Json::array();
    for (const Ranking& r : results.rankings) {
      const auto found = std::find(r.readings.begin(), r.readings.end(), own.fit.reading);
      const auto i = static_cast<std::size_t>(found - r.readings.begin());
      others.push_back({{"correlation", nullptr},
                        {"misfit", i < r.misfits.size() ? Json(r.misfits[i]) : Json()}});
    }
    rows.push_back({{"reading", name_of(own.fit.reading)},
                    {"own", own.fit.misfit},
                    {"others", std::move(others)}});
  }
  return {{"searches", std::move(searches)}, {"rows", std::move(rows)}};
}

/// What every other command computes with, and whether that is the choice.
Json usual_of(const Results& results) {
  const Fit& usual = results.usual.fit;
  const Fit& choice = results.choice().fit;
  Json data = data_of(results.usual);
  data["is_choice"] = usual.reading == choice.reading && usual.constants == choice.constants;
  return data;
}

/// A row a freedom, by rising misfit: what each search found.
Json convergence_of(const Results& results) {
  std::vector<std::size_t> order(results.convergence.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {},
                           [&](std::size_t i) { return results.convergence[i].best().misfit; });
  int agreed = 0;
  Json rows = Json::array();
  for (const std::size_t i : order) {
    const Convergence& one = results.convergence[i];
    const auto from = one.agreed_from();
    agreed += from ? 1 : 0;
    const std::vector<RankedFit>& fits = results.converged[i];
    Json row = data_of(fits.front());
    const auto error = [](const RankedFit& r) { return r.appraisal.threshold_error; };
    const auto [least, most] = std::ranges::minmax_element(fits, {}, error);
    row["as_good"] = fits.size();
    row["errors"] = {{"least", error(*least)}, {"most", error(*most)}};
    row["chosen"] = &fits.front() == &results.choice() ? Json(true) : Json();
    row["evaluations"] = one.evaluations;
    row["agreed"] = from.has_value();
    row["agreed_from"] = from ? Json(*from * static_cast<double>(one.evaluations)) : Json();
    row["spreads"] = Json::array();
    for (std::size_t k = 0; k < std::size(looked_at); ++k) row["spreads"].push_back(one.spread(k));
    row["searches"] = list_of(one.searches, [](const LongSearch& s) -> Json {
      return {{"last", s.last().misfit}};
    });
    rows.push_back(std::move(row));
  }
  const OrderOfPairs pairs = order_of_pairs(results.convergence);
  const auto searches = list_of(results.convergence.front().searches, [](const LongSearch& s) {
    return Json{{"solver", s.solver}, {"seed", s.seed}};
  });
  return {{"rows", std::move(rows)},
          {"all", results.convergence.size()},
          {"agreed", agreed},
          {"searches", searches},
          {"count", searches.size()},
          {"evaluations", results.plan.convergence->evaluations},
          {"reading_evaluations", results.plan.convergence->reading_evaluations},
          {"constants", default_reading().freed.size()},
          {"pairs", pairs.all},
          {"alike", pairs.all - static_cast<int>(pairs.ties.size())},
          {"ties", list_of(pairs.ties, [&](const auto& tie) -> Json {
             return {{"first", words_of(results.convergence[tie.first].freedom)},
                     {"second", words_of(results.convergence[tie.second].freedom)}};
           })}};
}

/// What a fit holds of its reading's constants, which of them the one before it fitted, and where
/// it reaches the goals.
Json frontier_row(const RankedFit& r, const std::vector<Open>& fitted_before) {
  std::string names;
  for (const Open open : open_of(r.fit.reading)) {
    if (!contains(r.fit.freed, open)) names += fmt::format(" {}", constant_of(open).name);
  }
  Json held;
  for (const Open open : fitted_before) {
    if (contains(r.fit.freed, open)) continue;
    held = {{"constant", words_of(open)},
            {"value", r.fit.constants[static_cast<std::size_t>(open)]},
            {"unit", constant_of(open).unit}};
    break;
  }
  const Appraisal& a = r.appraisal;
  Json row = data_of(r);
  row["name"] = names.empty() ? "nothing held" : "held:" + names;
  row["held"] = std::move(held);
  row["reached"] = {{"within", a.within == 10},         {"exact_counts", a.exact_counts == 10},
                    {"purity", a.purity >= 0.9},        {"misclassified", a.misclassified <= 0.02},
                    {"loudness", a.loudness >= 1.5},    {"right_examples", a.right_examples == 20},
                    {"quiet_share", a.quiet_share == 0}};
  return row;
}

Json frontier_of(const std::vector<RankedFit>& frontier) {
  Json rows = Json::array();
  std::vector<Open> fitted_before = frontier.front().fit.freed;
  for (const RankedFit& r : frontier) {
    rows.push_back(frontier_row(r, fitted_before));
    fitted_before = r.fit.freed;
  }
  return rows;
}

Json constants_of(const Fit& fit) {
  return list_of(open_of(fit.reading), [&](Open open) -> Json {
    const OpenConstant& c = constant_of(open);
    return {{"constant", words_of(open)},
            {"value", fit.constants[static_cast<std::size_t>(open)]},
            {"unit", c.unit},
            {"freed", contains(fit.freed, open)},
            {"lower", c.lower},
            {"upper", c.upper},
            {"why", c.why}};
  });
}

Json predictions_of(const Results& results) {
  return list_of(results.predictions, [&](const Prediction& p) -> Json {
    std::optional<double> fitted;
    for (const CaseAppraisal& c : results.choice().appraisal.cases) {
      if (c.the_case.id == p.case_id) fitted = c.score.threshold;
    }
    return {{"id", p.case_id},
            {"paper", p.paper},
            {"fitted", fitted},
            {"predicted", p.predicted},
            {"off", p.predicted ? Json(std::log(*p.predicted / p.paper)) : Json()}};
  });
}

Json interval_of(const Profile& p) {
  return {{"constant", words_of(p.constant)},
          {"value", p.value},
          {"lower", p.lower},
          {"upper", p.upper},
          {"lower_open", p.lower_open},
          {"upper_open", p.upper_open},
          {"unit", constant_of(p.constant).unit},
          {"determined", !p.lower_open && !p.upper_open}};
}

Json points_of(const Profile& profile) {
  return list_of(profile.points, [](const auto& point) -> Json {
    return {{"value", point.first}, {"misfit", point.second}};
  });
}

/// What the threshold of each case owes to a constant of the choice, a row a constant.
Json sensitivity_of(const Results& results) {
  Json rows = Json::array();
  const std::vector<Open>& freed = results.choice().fit.freed;
  for (std::size_t i = 0; i < freed.size(); ++i) {
    const auto slope = [i](const CaseSensitivity& row) { return row.slopes[i]; };
    rows.push_back(
        {{"constant", words_of(freed[i])}, {"slopes", list_of(results.sensitivities, slope)}});
  }
  return {{"cases", list_of(results.sensitivities, &CaseSensitivity::case_id)},
          {"constants", std::move(rows)}};
}

Json plan_of(const Plan& plan) {
  const auto of = [](const Solver& solver) {
    return Json{{"name", solver.name}, {"version", solver.version}};
  };
  return {{"global", of(plan.search.global)},
          {"least_squares", of(plan.search.least_squares)},
          {"local", of(plan.search.local)},
          {"seed", plan.search.seed},
          {"evaluations", plan.search.evaluations},
          {"finalist_evaluations", plan.finalist_evaluations},
          {"pin_evaluations", plan.pin_evaluations},
          {"left_out_evaluations", plan.left_out_evaluations},
          {"step", plan.step}};
}

}  // namespace

Json data_of(const Results& results) {
  constexpr std::size_t nearest = 31;  // shown on the page
  const double unseen = prediction_error(results.predictions);
  const auto& profiles = results.profiles;
  Json data = {{"plan", plan_of(results.plan)},
               {"choice", data_of(results.choice())},
               {"best", data_of(results.readings.front())},
               {"usual", usual_of(results)},
               {"compared", results.readings.size() > 1},
               {"nearest", Json::array()},
               {"others", Json::array()},
               {"answers", answers_of(results.readings)},
               {"rankings", results.rankings.empty() ? Json() : rankings_of(results)},
               {"convergence", results.convergence.empty() ? Json() : convergence_of(results)},
               {"frontier", frontier_of(results.frontier)},
               {"constants", constants_of(results.choice().fit)},
               {"prediction_error", unseen},
               {"memory", unseen > 0.1},
               {"predictions", predictions_of(results)},
               {"determined",
                std::count_if(profiles.begin(), profiles.end(),
                              [](const Profile& p) { return !p.lower_open && !p.upper_open; })},
               {"intervals", list_of(profiles, interval_of)},
               {"sensitivity", sensitivity_of(results)},
               {"profiles", Json::object()}};
  data["best"]["description"] = description_of(results.readings.front().fit.reading);
  for (const RankedFit& r : results.readings) {
    data[data["nearest"].size() < nearest ? "nearest" : "others"].push_back(data_of(r));
  }
  for (const Profile& p : profiles) data["profiles"][words_of(p.constant)] = points_of(p);
  return data;
}

}  // namespace ricochet::studies::calibration
