#include <algorithm>
#include <cmath>

#include "problems/carrier_track/questions/speed_range.h"
#include "src/core/problem.h"
#include "src/studies/surrogate/gradient_doubt.h"

namespace ricochet::studies::surrogate {
namespace {

using carrier_track::fastest_speed;
using report::Json;

/// Shares of the points, but `trending` is a share of those that have a trend.
Json data_of(const GradientQuality& q) {
  const auto share = [](int part, int whole) {
    return whole > 0 ? Json(static_cast<double>(part) / whole) : Json();
  };
  const auto doubted = [&](GradientDoubt doubt) {
    return share(q.doubts[static_cast<std::size_t>(doubt)], q.points);
  };
  return {{"points", q.points},
          {"agreeing", share(q.agreeing, q.points)},
          {"flat", doubted(GradientDoubt::flat)},
          {"kink", doubted(GradientDoubt::kink)},
          {"sensitive", doubted(GradientDoubt::sensitive)},
          {"trending", share(q.right, q.trending)},
          {"reach", std::pow(10.0, q.log_reach)},
          {"log_reach", q.log_reach}};
}

/// A cell each by speed.
Json cells_of(const CaseQuality& row) {
  Json cells = Json::array();
  for (const GradientQuality& quality : row.cells) cells.push_back(data_of(quality));
  return cells;
}

}  // namespace

Json data_of(const GradientDoubtStudy& study) {
  GradientQuality all;
  for (const CaseQuality& row : study.rows) {
    for (const GradientQuality& q : row.cells) {
      all.points += q.points;
      all.agreeing += q.agreeing;
      all.trending += q.trending;
      all.right += q.right;
      for (std::size_t d = 0; d < all.doubts.size(); ++d) all.doubts[d] += q.doubts[d];
    }
  }
  Json widths = Json::array();
  for (std::size_t w = 0; w < study.plan.widths.size(); ++w) {
    widths.push_back({{"width", study.plan.widths[w]}});
    widths.back().update(data_of(study.by_width[w]));
  }
  Json speeds = Json::array(), cases = Json::array(), steps = Json::array();
  for (int k = 0; k < study.plan.cells; ++k) {
    speeds.push_back((k + 0.5) * (fastest_speed / study.plan.cells));
  }
  for (const CaseQuality& row : study.rows) {
    cases.push_back({{"id", row.id}, {"cells", cells_of(row)}});
  }
  for (const StepError& error : study.step_errors) {
    steps.push_back({{"step", error.step},
                     {"median", std::max(error.median, 1e-16)},
                     {"upper", std::max(error.upper, 1e-16)}});
  }
  return {{"all", data_of(all)},
          {"widths", std::move(widths)},
          {"speeds", std::move(speeds)},
          {"cases", std::move(cases)},
          {"steps", std::move(steps)}};
}

}  // namespace ricochet::studies::surrogate
