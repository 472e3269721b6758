#include "src/studies/calibration/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "ricochet/error.h"
#include "ricochet/solver.h"
#include "src/core/files.h"
#include "src/core/progress.h"
#include "src/report/json.h"
#include "src/studies/calibration/results.h"
#include "src/studies/paper/interpretation.h"
#include "src/studies/paper/loss.h"

namespace ricochet::studies {

namespace {

using namespace calibration;

/// Throws InputError for invalid options.
Plan plan_of(const CalibrationOptions& options, bool quick) {
  if (options.all_interpretations && !options.interpretation.empty()) {
    throw InputError("--all-interpretations stands alone: it takes no --interpretation");
  }
  if (options.seed < 0) {
    throw InputError(fmt::format("--seed {}: must be >= 0", options.seed));
  }
  const Search search{solver_named(options.solver, "--solver"), solver_named("ceres-trust-region"),
                      solver_named("nlopt-sbplx"), 0, options.seed};
  Plan plan = quick ? quick_plan(search) : full_plan(search);
  if (!options.all_interpretations) {
    plan.interpretations = {options.interpretation.empty()
                                ? carrier_track::default_interpretation().interpretation
                                : carrier_track::find_interpretation(options.interpretation)};
  }
  if (options.converge) {
    const auto convergence = quick ? quick_convergence : full_convergence;
    plan.convergence = convergence(solver_named("pagmo-sade"), solver_named("pagmo-de1220"));
  }
  return plan;
}

void write_interpretation(const Fit& fit, const CalibrationOptions& options) {
  const auto fitted = carrier_track::fitted_interpretation(
      fit.interpretation, fit.constants, fit.free,
      fmt::format("ricochet calibrate{}{}{} --seed {} --solver {}",
                  options.all_interpretations ? " --all-interpretations" : " --interpretation ",
                  options.all_interpretations ? "" : name_of(fit.interpretation),
                  options.converge ? " --converge" : "", options.seed, options.solver),
      "the choice");
  write_text_file(options.folder / "interpretation.toml", write_fitted_interpretation(fitted),
                  SymbolicLinks::refused);
}

}  // namespace

Study calibration_study(const CalibrationOptions& options) {
  const auto compute = [options](bool quick) {
    const Plan plan = plan_of(options, quick);
    std::filesystem::create_directories(options.folder);
    const std::filesystem::path fits = options.folder / "fits.toml";
    FitStore store(fits);
    const AtInterruption kept(
        [] {},
        fmt::format("finished fits are kept in {}: the same command goes on", fits.string()));
    const Results results = calibrate(plan, store);
    const Fit& choice = results.choice().fit;
    if (carrier_track::is_one_scene(choice.interpretation)) write_interpretation(choice, options);
    return data_of(results);
  };
  return {"calibration", "A first look, in half a minute", compute};
}

}  // namespace ricochet::studies

namespace ricochet::studies::calibration {

namespace {

using namespace carrier_track;
using report::Json;
using report::list_of;

const UnknownParameter& constant_of(Unknown open) {
  return unknown_parameters()[static_cast<std::size_t>(open)];
}

/// "projected-constant-revolutions (5)": with the number of its free constants.
std::string name_with_size(const Parameterisation& parameterisation) {
  return fmt::format("{} ({})", name_of(parameterisation.interpretation),
                     parameterisation.free.size());
}

Json data_of(const RankedFit& r) {
  Json data = {{"interpretation", name_of(r.fit.interpretation)},
               {"constants", r.fit.free.size()},
               {"loss", r.fit.loss}};
  data.update(Json(r.appraisal));
  return data;
}

/// The best interpretation for every answer to every question of the paper.
Json answers_of(const std::vector<RankedFit>& interpretations) {
  std::vector<std::string> problems;
  std::map<std::string, std::map<std::string, const RankedFit*>> best;
  for (const RankedFit& r : interpretations) {
    for (const auto& [problem, answer] : carrier_track::answers_of(r.fit.interpretation)) {
      if (!best.contains(problem)) problems.push_back(problem);
      best[problem].try_emplace(answer, &r);  // by rising loss: the first is the best
    }
  }
  Json rows = Json::array();
  for (const std::string& problem : problems) {
    for (const auto& [answer, r] : best[problem]) {
      Json row = {{"problem", problem},
                  {"answer", answer},
                  {"best", r == &interpretations.front() ? Json(true) : Json()}};
      row.update(data_of(*r));
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

/// The default interpretation, which every other command uses, and whether it is the choice.
Json usual_of(const Results& results) {
  const Fit& usual = results.usual.fit;
  const Fit& choice = results.choice().fit;
  Json data = data_of(results.usual);
  data["is_choice"] =
      usual.interpretation == choice.interpretation && usual.constants == choice.constants;
  return data;
}

/// A row for each parameterisation, by rising loss: the result of each search.
Json convergence_of(const Results& results) {
  std::vector<std::size_t> order(results.convergence.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {},
                           [&](std::size_t i) { return results.convergence[i].best().loss; });
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
      return {{"last", s.last().loss}};
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
          {"interpretation_evaluations", results.plan.convergence->interpretation_evaluations},
          {"constants", default_interpretation().free.size()},
          {"pairs", pairs.all},
          {"alike", pairs.all - static_cast<int>(pairs.ties.size())},
          {"ties", list_of(pairs.ties, [&](const auto& tie) -> Json {
             return {{"first", name_with_size(results.convergence[tie.first].parameterisation)},
                     {"second", name_with_size(results.convergence[tie.second].parameterisation)}};
           })}};
}

/// The fixed parameters of a fit, those of them that the previous fit had free, and its results for
/// the goals.
Json frontier_row(const RankedFit& r, const std::vector<Unknown>& fitted_before) {
  std::string names;
  for (const Unknown open : unknowns_of(r.fit.interpretation)) {
    if (!contains(r.fit.free, open)) names += fmt::format(" {}", constant_of(open).name);
  }
  Json held;
  for (const Unknown open : fitted_before) {
    if (contains(r.fit.free, open)) continue;
    held = {{"constant", words_of(open)},
            {"value", r.fit.constants[static_cast<std::size_t>(open)]},
            {"unit", constant_of(open).unit}};
    break;
  }
  const Appraisal& a = r.appraisal;
  Json row = data_of(r);
  row["name"] = names.empty() ? "nothing fixed" : "fixed:" + names;
  row["held"] = std::move(held);
  row["reached"] = {{"within", a.within == 10},
                    {"exact_counts", a.exact_counts == 10},
                    {"purity", a.purity >= least_purity},
                    {"misclassified", a.misclassified <= most_misclassified},
                    {"loudness", a.loudness >= least_loudness},
                    {"right_examples", a.right_examples == 20},
                    {"quiet_share", a.quiet_share == 0}};
  return row;
}

Json frontier_of(const std::vector<RankedFit>& frontier) {
  Json rows = Json::array();
  std::vector<Unknown> fitted_before = frontier.front().fit.free;
  for (const RankedFit& r : frontier) {
    rows.push_back(frontier_row(r, fitted_before));
    fitted_before = r.fit.free;
  }
  return rows;
}

Json constants_of(const Fit& fit) {
  return list_of(unknowns_of(fit.interpretation), [&](Unknown open) -> Json {
    const UnknownParameter& c = constant_of(open);
    return {{"constant", words_of(open)},
            {"value", fit.constants[static_cast<std::size_t>(open)]},
            {"unit", c.unit},
            {"free", contains(fit.free, open)},
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

/// Sensitivity of each case's threshold to the free parameters of the choice, a row for each
/// parameter.
Json sensitivity_of(const Results& results) {
  Json rows = Json::array();
  const std::vector<Unknown>& free = results.choice().fit.free;
  for (std::size_t i = 0; i < free.size(); ++i) {
    const auto slope = [i](const CaseSensitivity& row) { return row.slopes[i]; };
    rows.push_back(
        {{"constant", words_of(free[i])}, {"slopes", list_of(results.sensitivities, slope)}});
  }
  return {{"cases", list_of(results.sensitivities, &CaseSensitivity::case_id)},
          {"constants", std::move(rows)}};
}

Json plan_of(const Plan& plan) {
  return {{"global", solver_data(plan.search.global)},
          {"least_squares", solver_data(plan.search.least_squares)},
          {"local", solver_data(plan.search.local)},
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
               {"best", data_of(results.interpretations.front())},
               {"usual", usual_of(results)},
               {"compared", results.interpretations.size() > 1},
               {"nearest", Json::array()},
               {"others", Json::array()},
               {"answers", answers_of(results.interpretations)},
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
               {"sensitivity", sensitivity_of(results)}};
  data["best"]["description"] = description_of(results.interpretations.front().fit.interpretation);
  for (const RankedFit& r : results.interpretations) {
    data[data["nearest"].size() < nearest ? "nearest" : "others"].push_back(data_of(r));
  }
  return data;
}

}  // namespace ricochet::studies::calibration
