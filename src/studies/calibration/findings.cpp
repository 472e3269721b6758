#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/analysis/statistics/intervals.h"
#include "src/studies/calibration/results.h"
#include "src/studies/paper/interpretation.h"
#include "src/studies/paper/loss.h"

namespace ricochet::studies::calibration {

namespace {

using namespace carrier_track;
using report::Chart;
using report::Mark;
using report::Sample;
using report::Series;

const UnknownParameter& constant_of(Unknown open) {
  return unknown_parameters()[static_cast<std::size_t>(open)];
}

/// Its name in words: "centrifugal mass radius".
std::string words_of(Unknown open) {
  std::string words(constant_of(open).name);
  std::ranges::replace(words, '_', ' ');
  return words;
}

double percent(double share) {
  return 100 * share;
}

Chart chart_of(const char* name, const char* x, const char* y) {
  Chart chart;
  chart.name = name;
  chart.x.label = x;
  chart.y.label = y;
  chart.width = 720;
  return chart;
}

Series points_of(std::string_view label) {
  return {std::string(label), Mark::points, {}};
}

/// A table of fits: its own columns, and those of an appraisal.
Table table_of_fits(std::string name, std::vector<Column> columns) {
  const std::vector<Column> judged = {{"loss", "loss", ".1f"},
                                      {"error", "error [%]", ".1%"},
                                      {"within", "within 5 %"},
                                      {"exact_counts", "counts right"},
                                      {"purity", "purity [%]", ".0%"},
                                      {"misclassified", "misclassified [%]", ".1%"},
                                      {"loudness", "loudness", ".2f"},
                                      {"right_examples", "examples right"},
                                      {"quiet_share", "C11 quiet [%]", ".0%"},
                                      {"criterion", "AICc", ".1f"}};
  columns.insert(columns.end(), judged.begin(), judged.end());
  return {std::move(name), std::move(columns)};
}

/// A row of such a table.
std::vector<Value> row_of(std::vector<Value> own, const RankedFit& r) {
  own.push_back(value_of(r.fit.loss));
  visit_fields([&](const Field& /*field*/, const auto& x) { own.push_back(value_of(x)); },
               r.appraisal);
  return own;
}

Table interpretations_of(const std::vector<RankedFit>& interpretations) {
  Table table = table_of_fits("interpretations", {{"interpretation"}, {"constants"}});
  for (const RankedFit& r : interpretations) {
    table.add_row(
        row_of({value_of(name_of(r.fit.interpretation)), value_of(r.fit.free.size())}, r));
  }
  return table;
}

/// Every answer to a question of the paper that the closest interpretation does not give, with the
/// best interpretation that gives it.
Table answers_of(const std::vector<RankedFit>& interpretations) {
  Table table = table_of_fits(
      "answers", {{"question"}, {"closest", "closest answer"}, {"answer"}, {"interpretation"}});
  std::vector<std::string> questions;
  std::map<std::string, std::map<std::string, const RankedFit*>> best;
  for (const RankedFit& r : interpretations) {
    for (const auto& [question, answer] : carrier_track::answers_of(r.fit.interpretation)) {
      if (!best.contains(question)) questions.push_back(question);
      best[question].try_emplace(answer, &r);  // by rising loss: the first is the best
    }
  }
  for (const std::string& question : questions) {
    const auto closest = std::ranges::find(best[question], &interpretations.front(),
                                           [](const auto& answer) { return answer.second; });
    for (const auto& [answer, r] : best[question]) {
      if (answer == closest->first) continue;
      table.add_row(row_of({value_of(question), value_of(closest->first), value_of(answer),
                            value_of(name_of(r->fit.interpretation))},
                           *r));
    }
  }
  return table;
}

constexpr int resamples = 10'000;

Interval interval_of(const std::vector<std::vector<double>>& groups) {
  return root_mean_square_interval(groups, 0.95, resamples, 1);
}

/// The error of thresholds in the fit, and of those left out of it, from the least that is left out
/// to the most.
Table left_out_of(const std::vector<Prediction>& predictions) {
  Table table{"left-out",
              {{"fit", "threshold"},
               {"refits"},
               {"error", "error [%]", ".1%"},
               {"lower", "from [%]", ".1%"},
               {"upper", "to [%]", ".1%"},
               {"worst", "worst [%]", "+.1%"},
               {"missing", "no threshold"}}};
  for (const LeftOut what : all_left_out) {
    const std::vector<Prediction> some = predictions_without(what, predictions);
    const std::vector<double> errors = errors_of(some);
    if (errors.empty()) continue;
    std::vector<std::vector<double>> alone;
    for (const double error : errors) alone.push_back({error});
    const Interval interval = interval_of(alone);
    const double worst =
        *std::ranges::max_element(errors, {}, [](double error) { return std::abs(error); });
    const auto missing =
        std::ranges::count_if(some, [](const Prediction& p) { return !p.predicted.has_value(); });
    table.add(what, groups_of(what).size(), root_mean_square(errors), interval.lower,
              interval.upper, worst, missing);
  }
  return table;
}

/// The threshold of each case [rad/s], by the fit and by those that do not know it.
Table predictions_of(const std::vector<Prediction>& predictions) {
  Table table{"predictions", {{"case"}, {"restitution"}, {"friction"}, {"paper"}}};
  for (const LeftOut what : all_left_out) {
    std::string name(name_of(names_of(what), what));
    std::ranges::replace(name, ' ', '_');
    table.columns.push_back({name, "", ".2f"});
  }
  for (const Case& c : all_cases()) {
    std::vector<Value> row = {value_of(c.id), value_of(c.restitution), value_of(c.friction),
                              value_of(c.claim.threshold)};
    for (const LeftOut what : all_left_out) {
      const auto of_kind = predictions_without(what, predictions);
      const auto found = std::ranges::find(of_kind, c.id, &Prediction::case_id);
      row.push_back(found == of_kind.end() ? Value() : value_of(found->predicted));
    }
    if (c.claim.threshold) table.add_row(std::move(row));
  }
  return table;
}

/// Errors of the thresholds of each case, in the fit and left out of it.
Chart left_out_chart(const std::vector<Prediction>& predictions) {
  Chart chart = chart_of("left-out", "case", "error of the threshold [%]");
  std::map<std::string, double> places;
  for (const Prediction& p : predictions_without(LeftOut::nothing, predictions)) {
    places.emplace(p.case_id, chart.x.categories.size());
    chart.x.categories.push_back(p.case_id);
  }
  std::map<LeftOut, double> errors;
  for (const LeftOut what : all_left_out) {
    const auto of_kind = predictions_without(what, predictions);
    if (of_kind.empty() || what == LeftOut::one_case) continue;
    errors[what] = percent(root_mean_square(errors_of(of_kind)));
    Series series = points_of(name_of(names_of(what), what));
    series.dark = what == LeftOut::nothing;
    for (const Prediction& p : of_kind)
      series.samples.push_back({places.at(p.case_id), percent(p.error())});
    chart.series.push_back(std::move(series));
  }
  chart.lines = {{report::Direction::horizontal, 0, ""}};
  chart.title = fmt::format("Without its machine a threshold is {:.0f} % off, in the fit {:.0f} %",
                            errors[LeftOut::machine], errors[LeftOut::nothing]);
  return chart;
}

/// Each constant with its value, what was allowed, and between what values the claims hold it.
Table constants_of(const Results& results) {
  Table table{"constants",
              columns_named("constant,value,unit,fitted,from,to,determined,lower,upper,why")};
  const Fit& fit = results.choice().fit;
  for (const Unknown open : unknowns_of(fit.interpretation)) {
    const UnknownParameter& c = constant_of(open);
    const auto found = std::ranges::find(results.profiles, open, &Profile::constant);
    const Profile* profile = found == results.profiles.end() ? nullptr : &*found;
    table.add(words_of(open), fit.constants[static_cast<std::size_t>(open)], c.unit,
              contains(fit.free, open), profile ? value_of(profile->lower) : Value(),
              profile ? value_of(profile->upper) : Value(),
              profile ? value_of(profile->is_determined()) : Value(), c.lower, c.upper, c.why);
  }
  return table;
}

/// One interpretation with fewer and fewer free constants.
Table frontier_of(const std::vector<RankedFit>& frontier) {
  Table table = table_of_fits("frontier", {{"constants"}, {"fixed", "fixed from here on"}});
  std::vector<Unknown> fitted_before = frontier.front().fit.free;
  for (const RankedFit& r : frontier) {
    std::string fixed = "none";
    for (const Unknown open : fitted_before) {
      if (contains(r.fit.free, open)) continue;
      std::string_view unit = constant_of(open).unit;
      const double value = r.fit.constants[static_cast<std::size_t>(open)];
      if (value == 1 && unit == "turns") unit = "turn";
      fixed = fmt::format("{} = {:.4g}{}{}", words_of(open), value, unit.empty() ? "" : " ", unit);
    }
    table.add_row(row_of({value_of(r.fit.free.size()), value_of(fixed)}, r));
    fitted_before = r.fit.free;
  }
  return table;
}

Sample sample_of(const RankedFit& r) {
  return {static_cast<double>(r.fit.free.size()), percent(r.appraisal.threshold_error)};
}

/// Error over the number of fitted constants.
Chart error_chart(const Results& results) {
  Chart chart =
      chart_of("error-against-constants", "fitted constants", "error of the thresholds [%]");
  chart.x.range = report::Range{1, 13};
  chart.y.scale = report::Scale::logarithmic;
  Series brief = points_of("all constants of an interpretation");
  for (const RankedFit& r : results.interpretations) brief.samples.push_back(sample_of(r));
  Series frontier{"fixed one by one", Mark::line, {}};
  for (const RankedFit& r : results.frontier) frontier.samples.push_back(sample_of(r));
  std::ranges::reverse(frontier.samples);
  Series thorough = points_of("searched at length");
  for (const auto& fits : results.converged) {
    thorough.samples.push_back(sample_of(fits.front()));
    if (&fits.front() == &results.choice()) thorough.samples.back().name = "chosen";
  }
  for (Series* series : {&brief, &frontier, &thorough}) {
    if (!series->samples.empty()) chart.series.push_back(std::move(*series));
  }
  const RankedFit& choice = results.choice();
  const auto on_curve = std::ranges::find(results.frontier, choice.fit.free.size(),
                                          [](const RankedFit& r) { return r.fit.free.size(); });
  chart.title = fmt::format("{} fitted constants: {:.1f} %", choice.fit.free.size(),
                            percent(choice.appraisal.threshold_error));
  if (on_curve != results.frontier.end() && &*on_curve != &choice)
    chart.title += fmt::format(" if searched at length, {:.1f} % if fixed one by one",
                               percent(on_curve->appraisal.threshold_error));
  return chart;
}

/// What searches for the same constants ended with, a row for each parameterisation, by rising
/// loss. Appraised is that with the lowest criterion of those within 1 % of the best.
Table searches_of(const Results& results) {
  Table table = table_of_fits(
      "searches",
      columns_named(
          "interpretation,constants,evaluations,best,as_good,least_error,largest_error,chosen"));
  if (results.convergence.empty()) return table;
  const LongSearches& plan = *results.plan.long_searches;
  for (const Solver& solver : plan.solvers) {
    for (const int seed : plan.seeds)
      table.columns.push_back({fmt::format("{}-{}", solver.name, seed)});
  }
  std::vector<std::size_t> order(results.convergence.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto best = [&](std::size_t i) { return best_of(results.convergence[i].fits).loss; };
  std::ranges::stable_sort(order, {}, best);
  for (const std::size_t i : order) {
    const Convergence& one = results.convergence[i];
    const std::vector<RankedFit>& fits = results.converged[i];
    const auto error = [](const RankedFit& r) { return r.appraisal.threshold_error; };
    const auto [least, most] = std::ranges::minmax_element(fits, {}, error);
    std::vector<Value> row =
        row_of({value_of(name_of(fits.front().fit.interpretation)),
                value_of(fits.front().fit.free.size()), value_of(one.evaluations),
                value_of(best(i)), value_of(fits.size()), value_of(error(*least)),
                value_of(error(*most)), value_of(&fits.front() == &results.choice())},
               fits.front());
    for (const Fit& fit : one.fits) row.push_back(value_of(fit.loss));
    table.add_row(std::move(row));
  }
  return table;
}

Row row_without(const Table& left_out, LeftOut what) {
  return left_out
      .find([&](const Row& row) { return row.text("fit") == name_of(names_of(what), what); })
      .value();
}

/// How far off the thresholds are that were left out of the fit.
std::string prediction_of(const Table& left_out) {
  const auto error = [&](LeftOut what) {
    return percent(row_without(left_out, what).number("error"));
  };
  return fmt::format(
      "Left out of the fit with its whole machine, a threshold is {:.0f} % off; with all cases of "
      "its restitution {:.0f} %, of its friction {:.0f} %.",
      error(LeftOut::machine), error(LeftOut::restitution), error(LeftOut::friction));
}

/// The answer, for this page and for others.
std::string finding_of(const Results& results, const Table& left_out) {
  const Row fit = row_without(left_out, LeftOut::nothing);
  return fmt::format(
      "{} constants are fitted to the paper's ten thresholds; the root-mean-square error in log "
      "speed is {:.1f} % (95 % interval {:.1f} to {:.1f} %). {}",
      results.choice().fit.free.size(), percent(fit.number("error")), percent(fit.number("lower")),
      percent(fit.number("upper")), prediction_of(left_out));
}

std::optional<std::string> open_ends_of(const std::vector<Profile>& profiles) {
  std::vector<std::string> open;
  for (const Profile& p : profiles) {
    if (!p.is_determined()) open.push_back(words_of(p.constant));
  }
  if (open.empty()) return {};
  return fmt::format("The interval ends only where values are no longer allowed for: {}.",
                     fmt::join(open, ", "));
}

/// What every other command computes with, if it is not the choice.
std::optional<std::string> other_fit_of(const Results& results) {
  const RankedFit& usual = results.usual;
  const Fit& choice = results.choice().fit;
  if (usual.fit.interpretation == choice.interpretation && usual.fit.constants == choice.constants)
    return {};
  return fmt::format(
      "Every other command computes with another fit, {}: {} constants, loss {:.2f} in place of "
      "{:.2f}, thresholds {:.1f} % off.",
      name_of(usual.fit.interpretation), usual.fit.free.size(), usual.fit.loss, choice.loss,
      percent(usual.appraisal.threshold_error));
}

std::optional<std::string> agreement_of(const std::vector<Convergence>& all) {
  if (all.empty()) return {};
  return fmt::format("The {} searches end within 1 % of the best of them in {} of {} rows.",
                     all.front().fits.size(), std::ranges::count_if(all, &Convergence::agrees),
                     all.size());
}

std::optional<std::string> closest_of(const std::vector<RankedFit>& interpretations) {
  if (interpretations.size() < 2) return {};
  const RankedFit& best = interpretations.front();
  return fmt::format(
      "Of {} interpretations with all their constants free, the closest is: {}. With {} constants "
      "it "
      "has a loss of {:.1f} and thresholds {:.1f} % off.",
      interpretations.size(), description_of(best.fit.interpretation), best.fit.free.size(),
      best.fit.loss, percent(best.appraisal.threshold_error));
}

void set_plan(report::Results& found, const Plan& plan) {
  const auto solver = [](const Solver& s) { return fmt::format("{} ({})", s.name, s.version); };
  found.set("global", solver(plan.search.global));
  found.set("least-squares", solver(plan.search.least_squares));
  found.set("local", solver(plan.search.local));
  found.set("seed", plan.search.seed);
  found.set("evaluations", plan.search.evaluations);
  found.set("finalist-evaluations", plan.finalist_evaluations);
  found.set("pin-evaluations", plan.pin_evaluations);
  found.set("left-out-evaluations", plan.left_out_evaluations);
  found.set("left-out-searches", plan.left_out_searches);
  found.set("step", plan.step);
}

}  // namespace

report::Results findings_of(const Results& results) {
  const RankedFit& choice = results.choice();
  Table left_out = left_out_of(results.predictions);
  const Interval by_machine =
      interval_of(errors_by_machine(predictions_without(LeftOut::nothing, results.predictions)));

  report::Results found;
  found.set("finding", finding_of(results, left_out));
  found.set("prediction", prediction_of(left_out));
  found.set("interpretation", name_of(choice.fit.interpretation));
  found.set("description", description_of(choice.fit.interpretation));
  found.set("constants", choice.fit.free.size());
  found.set("within", choice.appraisal.within);
  found.set("exact-counts", choice.appraisal.exact_counts);
  found.set("right-examples", choice.appraisal.right_examples);
  found.set("lower-by-machine", by_machine.lower);
  found.set("upper-by-machine", by_machine.upper);
  found.set("resamples", resamples);
  found.set("determined", std::ranges::count_if(results.profiles, &Profile::is_determined));
  found.set("open-ends", open_ends_of(results.profiles));
  found.set("other-fit", other_fit_of(results));
  found.set("frontier-interpretation", name_of(results.frontier.front().fit.interpretation));
  found.set("agreement", agreement_of(results.convergence));
  found.set("closest", closest_of(results.interpretations));
  found.set("note", std::nullopt);  // of a report that was put together from several runs
  set_plan(found, results.plan);

  found.add(std::move(left_out));
  found.add(predictions_of(results.predictions));
  found.add(constants_of(results));
  found.add(frontier_of(results.frontier));
  found.add(searches_of(results));
  found.add(interpretations_of(results.interpretations));
  found.add(answers_of(results.interpretations));
  found.add(left_out_chart(results.predictions));
  found.add(error_chart(results));
  return found;
}

}  // namespace ricochet::studies::calibration
