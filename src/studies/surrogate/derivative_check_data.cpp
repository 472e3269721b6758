#include <algorithm>
#include <array>
#include <cmath>

#include "src/core/difference.h"
#include "src/statistics/bootstrap.h"
#include "src/studies/surrogate/derivative_check.h"
#include "src/studies/surrogate/tail.h"

namespace ricochet::studies::surrogate {
namespace {

using report::Json;

constexpr std::array<const char*, causes> cause_names = {"none", "flat", "short reach", "rounding",
                                                         "unexplained"};

Json data_of(const DerivativeErrors& row) {
  const auto of = [&](Cause cause) { return row.by_cause[static_cast<std::size_t>(cause)]; };
  return {{"family", row.family},
          {"function", row.function},
          {"points", row.points},
          {"median", quantile(row.errors, 0.5)},
          {"of_10", quantile(row.errors, 0.9)},
          {"of_100", quantile(row.errors, 0.99)},
          {"worst", quantile(row.errors, 1.0)},
          {"flat", of(Cause::flat)},
          {"reach", of(Cause::reach)},
          {"rounding", of(Cause::rounding)},
          {"unexplained", of(Cause::unexplained)},
          {"explained", of(Cause::unexplained) == 0}};
}

Json data_of(const Outlier& outlier) {
  const Comparison& c = outlier.comparison;
  return {{"problem", outlier.problem},
          {"at", outlier.point[0]},
          {"exact", c.exact},
          {"difference", c.difference},
          {"error", c.error},
          {"reach", c.trust.reach},
          {"cause", cause_names[static_cast<std::size_t>(c.cause)]},
          {"explained", c.cause == Cause::unexplained ? Json(false) : Json()}};
}

Json tails_of(const DerivativeCheckStudy& study) {
  Json tails = Json::array();
  for (const DerivativeErrors& row : study.rows) {
    tails.push_back(
        {{"family", row.family}, {"function", row.function}, {"tail", tail_of(row.errors)}});
  }
  return tails;
}

}  // namespace

Json data_of(const DerivativeCheckStudy& study) {
  DerivativeErrors total{"all", "", study.points, {}, {}};
  Json rows = Json::array();
  for (const DerivativeErrors& row : study.rows) {
    rows.push_back(data_of(row));
    total.errors.insert(total.errors.end(), row.errors.begin(), row.errors.end());
    for (std::size_t c = 0; c < causes; ++c) total.by_cause[c] += row.by_cause[c];
  }
  std::sort(total.errors.begin(), total.errors.end());
  rows.push_back(data_of(total));
  Json shown = Json::array();
  for (std::size_t k = 0; k < std::min<std::size_t>(20, study.outliers.size()); ++k) {
    shown.push_back(data_of(study.outliers[k]));
  }
  return {{"families", study.families},
          {"derivatives", total.errors.size()},
          {"all", rows.back()},
          {"outlier", outlier},
          {"nothing", nothing},
          {"first_step", first_step},
          {"steps", Extrapolation<>::levels},
          {"seed", study.seed},
          {"rows", rows},
          {"outliers", study.outliers.size()},
          {"shown", shown.size()},
          {"first_outliers", std::move(shown)},
          {"tails", tails_of(study)}};
}

}  // namespace ricochet::studies::surrogate
