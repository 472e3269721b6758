#include "problems/carrier_track/check/oracle.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "problems/carrier_track/check/body.h"
#include "problems/carrier_track/counting/recording.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track::inline oracle {

OracleRun oracle_run(const Scene& scene) {
  return of_body::Body(scene, Push(scene)).run();
}

OracleRun oracle_run(const Scene& scene, const TermPush& push) {
  return of_body::Body(scene, push).run();
}

std::vector<Impact> faster(const std::vector<Impact>& impacts, double counting_limit) {
  std::vector<Impact> result;
  std::copy_if(impacts.begin(), impacts.end(), std::back_inserter(result),
               [counting_limit](const Impact& impact) { return impact.speed > counting_limit; });
  return result;
}

std::vector<Peak> counted(const std::vector<Peak>& maxima, const Scene& scene) {
  std::vector<Peak> result;
  std::copy_if(maxima.begin(), maxima.end(), std::back_inserter(result), [&](const Peak& peak) {
    return peak.position > scene.peak_high || peak.position < scene.peak_low;
  });
  return result;
}

namespace {

/// Pairs the impacts of both lists.
void match(const std::vector<Impact>& found, const std::vector<Impact>& true_ones,
           Comparison& result) {
  const std::size_t pairs = std::min(found.size(), true_ones.size());
  for (std::size_t k = 0; k < pairs && found[k].wall == true_ones[k].wall; ++k) {
    ++result.matched;
    result.time_error = std::max(result.time_error, std::abs(found[k].time - true_ones[k].time));
    result.speed_error =
        std::max(result.speed_error, std::abs(found[k].speed - true_ones[k].speed));
  }
  result.missed = static_cast<int>(true_ones.size()) - result.matched;
  result.spurious = static_cast<int>(found.size()) - result.matched;
}

/// The same for maxima, without errors: the time of a flat maximum is ill-conditioned.
void match(const std::vector<Peak>& found, const std::vector<Peak>& true_ones, Comparison& result) {
  result.matched = static_cast<int>(std::min(found.size(), true_ones.size()));
  result.missed = static_cast<int>(true_ones.size()) - result.matched;
  result.spurious = static_cast<int>(found.size()) - result.matched;
}

}  // namespace

Comparison compare(const Scene& scene) {
  Comparison result;
  const OracleRun true_values = oracle_run(scene);
  if (!true_values.finished) {
    result.compared = false;
    return result;
  }
  const Recording recording = record(scene, 0.0, 0);
  result.certain = recording.certainty.certain;
  result.count = recording.count;
  result.true_values = true_values.count;
  result.endless = true_values.endless;
  if (scene.rule == CountRule::impacts) {
    match(faster(recording.impacts, scene.counting_limit),
          faster(true_values.impacts, scene.counting_limit), result);
  } else {
    match(counted(recording.peaks, scene), counted(true_values.maxima, scene), result);
  }
  return result;
}

}  // namespace ricochet::carrier_track::inline oracle
