#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/benchmark/statistics/wilson_interval.h"
#include "src/research/calibration/fit.h"
#include "src/research/long_run/results.h"
#include "src/research/paper/threshold_formula.h"
#include "src/research/solver_data.h"

namespace ricochet::studies::long_run {

using namespace carrier_track;
using calibration::Appraisal;
using calibration::CaseAppraisal;
using report::Json;
using report::list_of;

namespace {

const double determined_within = std::log(3.0);
constexpr double undetermined = 1000;  // a factor that says nothing

Json interval_data(const Interval& interval) {
  return {{"lower", interval.lower}, {"upper", interval.upper}};
}

Json share_data(int right, int of) {
  Json data = interval_data(wilson_interval(right, of));
  data["right"] = right;
  data["of"] = of;
  return data;
}

Json error_data(const std::vector<double>& errors) {
  const RootMeanSquare rms = root_mean_square(errors);
  Json data = interval_data(rms.interval);
  data["value"] = rms.value;
  return data;
}

double largest(const std::vector<double>& errors) {
  double size = 0;
  for (const double error : errors) size = std::max(size, std::abs(error));
  return size;
}

/// The largest share, over the cases, of the speeds below the paper's threshold that are silent.
double silent_share(const Appraisal& appraisal) {
  double largest_share = 0;
  for (const CaseAppraisal& c : appraisal.cases) {
    if (!c.the_case.claim.threshold) continue;
    double silent = 0, below = 0;
    for (std::size_t k = 0; k < c.scan.counts.size(); ++k) {
      if (c.scan.omega(k) >= *c.the_case.claim.threshold) break;
      ++below;
      silent += c.scan.counts[k] == 0 ? 1 : 0;
    }
    if (below > 0) largest_share = std::max(largest_share, silent / below);
  }
  return largest_share;
}

Json thresholds_of(const std::vector<double>& errors) {
  const std::vector<Case> cases = cases_with_threshold();
  Json thresholds = Json::array();
  for (std::size_t i = 0; i < cases.size(); ++i) {
    thresholds.push_back({{"threshold", *cases[i].claim.threshold * std::exp(errors[i])}});
  }
  return thresholds;
}

/// A row of the verdict, from errors of thresholds alone.
Json row_of(const std::string& name, std::size_t parameters, const std::vector<double>& errors,
            const std::vector<double>& left_out) {
  return {{"name", name},
          {"parameters", parameters},
          {"error", error_data(errors)},
          {"worst", largest(errors)},
          {"left_out", error_data(left_out)},
          {"thresholds", thresholds_of(errors)},
          {"loss", nullptr},
          {"counts", nullptr},
          {"purity", nullptr},
          {"silent", nullptr},
          {"pure", nullptr},
          {"examples", nullptr}};
}

/// The same of an interpretation of counts.
Json row_of(const std::string& name, const calibration::Fit& fit, double loss,
            const Appraisal& appraisal, const std::vector<double>& left_out) {
  std::vector<double> errors;
  for (const CaseAppraisal& c : appraisal.cases) {
    if (c.the_case.claim.threshold) errors.push_back(error_of(c));
  }
  Json row = row_of(name, fit.free.size(), errors, left_out);
  row["loss"] = loss;
  row["counts"] = share_data(appraisal.exact_counts, static_cast<int>(errors.size()));
  row["purity"] = appraisal.purity;
  row["silent"] = silent_share(appraisal);
  row["pure"] = appraisal.purity >= purity_goal;
  row["examples"] = share_data(appraisal.right_examples, 20);
  return row;
}

Json constants_of(const std::string& name, const std::vector<Unknown>& free,
                  const Constants& constants) {
  Json rows = Json::array();
  for (const Unknown open : free) {
    const auto i = static_cast<std::size_t>(open);
    rows.push_back({{"name", name},
                    {"parameters", free.size()},
                    {"parameter", calibration::words_of(open)},
                    {"value", constants[i]},
                    {"unit", unknown_parameters()[i].unit}});
  }
  return rows;
}

void append(Json& list, const Json& more) {
  for (const Json& entry : more) list.push_back(entry);
}

Json border_row(const BorderFit& fit) {
  Json row = row_of(fit.what.name, fit.what.free.size(), fit.errors, fit.left_out);
  row["law_error"] = root_mean_square(fit.law_errors).value;
  int determined = 0;
  for (const Direction& d : fit.directions) {
    determined += d.half_width < determined_within ? 1 : 0;
  }
  row["determined"] = determined;
  row["directions"] = list_of(fit.directions, [&](const Direction& d) -> Json {
    std::string combination;
    for (std::size_t j = 0; j < d.weights.size(); ++j) {
      combination += fmt::format("{}{:+.2f} ln({})", j == 0 ? "" : " ", d.weights[j],
                                 calibration::words_of(fit.what.free[j]));
    }
    return {
        {"combination", combination},
        {"factor", std::exp(d.half_width) < undetermined ? Json(std::exp(d.half_width)) : Json()}};
  });
  return row;
}

Json intervals_of(const BorderFit& fit) {
  return list_of(fit.intervals, [&](const ParameterInterval& p) -> Json {
    return {{"name", fit.what.name},
            {"parameters", fit.what.free.size()},
            {"parameter", calibration::words_of(p.parameter)},
            {"unit", unknown_parameters()[static_cast<std::size_t>(p.parameter)].unit},
            {"value", p.value},
            {"lower", p.lower},
            {"upper", p.upper},
            {"lower_open", p.lower_open},
            {"upper_open", p.upper_open},
            {"determined", !p.lower_open && !p.upper_open}};
  });
}

Json formula_row(const char* fitted_to, const FormulaWorth& f) {
  return {{"fitted_to", fitted_to},
          {"c", f.c},
          {"k", f.k},
          {"rms", f.rms},
          {"worst", f.worst},
          {"rms_between", f.rms_between},
          {"worst_between", f.worst_between},
          {"factor_between", std::exp(std::abs(f.worst_between))}};
}

/// The chart's curves at a friction of the paper.
Json curve_of(const LawComparison& law, const FormulaWorth& paper, double friction) {
  const Formula formula = friction_formula();
  Json borders = Json::array(), curve = Json::array(), claims = Json::array();
  for (const LawPoint& p : law.points) {
    if (std::abs(p.friction - friction) > 1e-9) continue;
    if (p.border) borders.push_back({{"restitution", p.restitution}, {"threshold", *p.border}});
    const double at = formula.threshold({paper.c, paper.k}, {"", p.restitution, p.friction, 0, 0});
    curve.push_back({{"restitution", p.restitution}, {"formula", at}, {"law", p.law}});
  }
  for (const Case& c : cases_with_threshold()) {
    if (c.friction != friction) continue;
    claims.push_back({{"restitution", c.restitution}, {"threshold", *c.claim.threshold}});
  }
  return {{"friction", friction}, {"borders", borders}, {"curve", curve}, {"claims", claims}};
}

Json law_data(const LawComparison& law) {
  Json curves = Json::array();
  for (const double friction : {0.1, 0.4}) {
    curves.push_back(curve_of(law, law.of_paper, friction));
  }
  return {
      {"machines", law.points.size()},
      {"law_rms", law.law_rms},
      {"law_worst", law.law_worst},
      {"law_worst_struck", law.law_worst_struck},
      {"of_paper", formula_row("the paper's ten thresholds", law.of_paper)},
      {"of_corners", formula_row("", law.of_corners)},
      {"of_all", formula_row("", law.of_all)},
      {"formulas",
       {formula_row("the paper's ten thresholds", law.of_paper),
        formula_row("the borders at the paper's four restitutions and frictions", law.of_corners),
        formula_row("all of these borders", law.of_all)}},
      {"curves", std::move(curves)}};
}

}  // namespace

Json data_of(const Results& results) {
  const UsualFit& usual = results.usual;
  Json rows = {row_of("window after a start, the default", usual.fit, usual.fit.loss,
                      usual.appraisal, usual.left_out)};
  Json constants = Json::array(), borders = Json::array(), intervals = Json::array();
  Json purest = Json::array();
  for (const CountFit& c : results.counts) {
    const std::string& name = c.what.variant.name;
    const Json row = row_of(name, c.fit, c.loss, c.appraisal, c.left_out);
    rows.push_back(row);
    if (row["pure"] == true) purest.push_back(row);
    append(constants, constants_of(name, c.fit.free, c.fit.constants));
  }
  const auto left_out = [](const BorderFit& fit) { return root_mean_square(fit.left_out).value; };
  const auto best = std::ranges::min_element(results.borders, {}, left_out);
  for (const BorderFit& b : results.borders) {
    borders.push_back(border_row(b));
    rows.push_back(borders.back());
    append(constants, constants_of(b.what.name, b.what.free, b.constants));
    append(intervals, intervals_of(b));
  }
  const auto loss = [](const CountFit& fit) { return fit.loss; };
  const auto nearest = std::ranges::min_element(results.counts, {}, loss);
  const auto place = [](const auto& list, auto at) {
    return static_cast<std::size_t>(at - list.begin());
  };
  return {
      {"rows", rows},
      {"usual", rows[0]},
      {"nearest", rows[1 + place(results.counts, nearest)]},
      {"best_border", borders[place(results.borders, best)]},
      {"purest", purest},
      {"any_pure", purest.empty() ? Json() : Json(true)},
      {"descriptions",
       list_of(
           results.counts,
           [](const CountFit& c) -> Json {
             return {{"name", c.what.variant.name}, {"description", c.what.variant.description}};
           })},
      {"borders", borders},
      {"constants", constants},
      {"intervals", intervals},
      {"cases", list_of(cases_with_threshold(), &Case::id)},
      {"law", law_data(results.law)},
      {"plan",
       {{"global", solver_data(results.plan.counts.search.global)},
        {"local", solver_data(results.plan.counts.search.local)},
        {"least_squares", solver_data(results.plan.borders.least_squares)},
        {"count_evaluations", results.plan.counts.search.evaluations},
        {"border_evaluations", results.plan.borders.evaluations},
        {"step", results.plan.counts.step}}}};
}

}  // namespace ricochet::studies::long_run
