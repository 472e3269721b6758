#include <algorithm>
#include <cmath>

#include "src/statistics/bootstrap.h"
#include "src/studies/surrogate/bias.h"

namespace ricochet::studies::surrogate {
namespace {

using report::Json;

Json data_of(const Bias& bias) {
  return {{"width", bias.width},
          {"error", bias.error},
          {"rank_correlation", bias.rank_correlation},
          {"count_regret", bias.count_regret},
          {"count_is_lowest", bias.count_regret <= 0},
          {"speed", bias.speed},
          {"speed_regret", bias.speed_regret},
          {"quiet", bias.speed ? Json(!bias.loud) : Json()}};
}

/// How wrong the fastest quiet speed is over the cases, at one width.
Json over_cases(const BiasStudy& study, std::size_t width) {
  std::vector<double> wrong;
  int loud = 0;
  for (const CaseBias& row : study.cases) {
    const Bias& bias = row.biases[width];
    wrong.push_back(bias.speed_regret ? std::abs(*bias.speed_regret) : 18.0);
    loud += bias.loud ? 1 : 0;
  }
  return {{"width", study.plan.widths[width]},
          {"median", quantile(wrong, 0.5)},
          {"worst", *std::max_element(wrong.begin(), wrong.end())},
          {"loud", loud},
          {"cases", study.cases.size()}};
}

}  // namespace

Json data_of(const BiasStudy& study) {
  const std::size_t last = study.plan.widths.size() - 1;
  std::size_t usual = 0;
  while (usual < last && study.plan.widths[usual] > 0.25) ++usual;
  Json data = {{"usual", over_cases(study, usual)},
               {"narrowest", over_cases(study, last)},
               {"speeds", std::lround(18 / study.plan.step)},
               {"widths", study.plan.widths.size()},
               {"cases", Json::array()}};
  for (const CaseBias& row : study.cases) {
    Json widths = Json::array();
    for (const Bias& bias : row.biases) widths.push_back(data_of(bias));
    data["cases"].push_back({{"id", row.id},
                             {"lowest", row.lowest},
                             {"fastest", row.fastest},
                             {"widths", std::move(widths)}});
  }
  return data;
}

}  // namespace ricochet::studies::surrogate
