#include <algorithm>
#include <cmath>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/paper/fitted_reading.h"
#include "src/statistics/bootstrap.h"
#include "src/studies/surrogate/continuity.h"
#include "src/studies/surrogate/tail.h"

namespace ricochet::studies::surrogate {
namespace {

using report::Json;

struct Kind {
  const char* name;
  std::vector<std::vector<double>> ContinuityRow::*jumps;
};
constexpr Kind kinds[] = {{"steepest", &ContinuityRow::jumps}, {"birth", &ContinuityRow::births}};

/// The jumps of all cases at one width, rising.
std::vector<double> jumps_of(const ContinuityStudy& study, const Kind& kind, std::size_t width) {
  std::vector<double> all;
  for (const ContinuityRow& row : study.rows) {
    const std::vector<double>& jumps = (row.*kind.jumps)[width];
    all.insert(all.end(), jumps.begin(), jumps.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

Json data_of(const ContinuityRow& row) {
  Json jumps = Json::array();
  for (const auto& of_width : row.jumps) {
    jumps.push_back({{"jump", quantile(of_width, 0.99)}, {"small", nullptr}});
    jumps.push_back({{"jump", of_width.back()}, {"small", of_width.back() <= largest_allowed}});
  }
  return {{"id", row.id},
          {"segments", row.segments},
          {"count_jumps", static_cast<double>(row.count_jumps) / static_cast<double>(row.segments)},
          {"jumps", std::move(jumps)}};
}

/// What an impact with the speed of the last hops would count at a width.
double weight_at_rest(double width) {
  return carrier_track::step(
      std::log(carrier_track::resting_speed / carrier_track::default_reading().scene.slowest),
      width);
}

}  // namespace

Json data_of(const ContinuityStudy& study) {
  const std::vector<double>& widths = study.plan.widths;
  const double widest = *std::max_element(widths.begin(), widths.end());
  Json data = {{"allowed", largest_allowed}, {"resting_speed", carrier_track::resting_speed},
               {"widest", widest},           {"weight_at_rest", weight_at_rest(widest)},
               {"seed", study.plan.seed},    {"columns", Json::array()},
               {"worst", Json::array()},     {"widths", Json::array()},
               {"cases", Json::array()},     {"tails", Json::array()}};
  std::size_t births = 0;
  std::size_t larger = 0;
  for (std::size_t w = 0; w < widths.size(); ++w) {
    double worst = 0;
    for (const Kind& kind : kinds) {
      const std::vector<double> jumps = jumps_of(study, kind, w);
      if (jumps.empty()) continue;
      if (kind.jumps == &ContinuityRow::births) births += jumps.size();
      larger += larger_than(largest_allowed, jumps);
      worst = std::max(worst, jumps.back());
      data["tails"].push_back(
          {{"width", widths[w]}, {"where", kind.name}, {"tail", tail_of(jumps)}});
      data["widths"].push_back({{"width", widths[w]},
                                {"where", kind.name},
                                {"segments", jumps.size()},
                                {"half", quantile(jumps, 0.5)},
                                {"of_10", quantile(jumps, 0.9)},
                                {"of_100", quantile(jumps, 0.99)},
                                {"of_1000", quantile(jumps, 0.999)},
                                {"all", jumps.back()},
                                {"small", jumps.back() <= largest_allowed}});
    }
    data["worst"].push_back({{"width", widths[w]}, {"jump", worst}});
    data["columns"].push_back({{"width", widths[w]}, {"share", 0.99}});
    data["columns"].push_back({{"width", widths[w]}, {"share", nullptr}});
  }
  std::size_t segments = 0;
  std::size_t count_jumps = 0;
  std::vector<double> exponents;
  for (const ContinuityRow& row : study.rows) {
    segments += row.segments;
    count_jumps += row.count_jumps;
    exponents.insert(exponents.end(), row.exponents.begin(), row.exponents.end());
    data["cases"].push_back(data_of(row));
  }
  data["segments"] = segments;
  data["count_jumps"] = static_cast<double>(count_jumps) / static_cast<double>(segments);
  data["births"] = births;
  data["larger"] = larger > 0 ? Json(larger) : Json();
  data["exponents"] = nullptr;
  if (!exponents.empty()) {
    data["exponents"] = {{"median", quantile(exponents, 0.5)},
                         {"low", std::count_if(exponents.begin(), exponents.end(),
                                               [](double p) { return p < 0.4; })},
                         {"all", exponents.size()}};
  }
  return data;
}

}  // namespace ricochet::studies::surrogate
