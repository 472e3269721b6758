#include <algorithm>
#include <cmath>

#include "src/research/reproduction/data.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;
using report::Json;

/// Returns true if the step is at the threshold of the paper's rule, applied to the same counts.
bool is_near(const Step& step, const std::optional<double>& threshold) {
  return threshold && std::abs(std::log(step.omega / *threshold)) < std::log(1.1);
}

Json steps_of(const CaseStudy& c) {
  const auto main = c.staircase.main_step();
  Json steps = Json::array();
  for (const Step& step : c.staircase.steps) {
    steps.push_back({{"omega", step.omega},
                     {"below", step.below},
                     {"above", step.above},
                     {"significance", step.significance},
                     {"main", step.omega == main->omega}});
  }
  return {{"id", c.the_case.id},
          {"paper_threshold", c.the_case.claim.threshold},
          {"threshold", c.score.threshold},
          {"main", main ? Json(main->omega) : Json()},
          {"steps", std::move(steps)}};
}

}  // namespace

Json step_data(const std::vector<CaseStudy>& cases) {
  int thresholds = 0, with_step = 0, with_main_step = 0, without = 0;
  for (const CaseStudy& c : cases) {
    const auto& [steps, levels] = c.staircase;
    thresholds += c.score.threshold ? 1 : 0;
    without += steps.empty() ? 1 : 0;
    with_step += std::any_of(steps.begin(), steps.end(),
                             [&](const Step& step) { return is_near(step, c.score.threshold); });
    const auto main = c.staircase.main_step();
    with_main_step += main && is_near(*main, c.score.threshold) ? 1 : 0;
  }
  return {{"thresholds", thresholds},
          {"with_step", with_step},
          {"with_main_step", with_main_step},
          {"without", without},
          {"cases", report::list_of(cases, steps_of)}};
}

}  // namespace ricochet::studies::reproduction
