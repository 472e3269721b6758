#include "problems/carrier_track/oracle/comparison.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace ricochet::carrier_track::inline oracle {

std::vector<Impact> faster(const std::vector<Impact>& impacts, double slowest) {
  std::vector<Impact> result;
  std::copy_if(impacts.begin(), impacts.end(), std::back_inserter(result),
               [slowest](const Impact& impact) { return impact.speed > slowest; });
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

/// Pairs the impacts of the one and of the other.
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

/// The same of maxima; how exactly the time of a flat one is known says little.
void match(const std::vector<Peak>& found, const std::vector<Peak>& true_ones, Comparison& result) {
  result.matched = static_cast<int>(std::min(found.size(), true_ones.size()));
  result.missed = static_cast<int>(true_ones.size()) - result.matched;
  result.spurious = static_cast<int>(found.size()) - result.matched;
}

}  // namespace

Comparison compare(const Scene& scene) {
  Comparison result;
  const OracleRun truth = oracle_run(scene);
  if (!truth.finished) {
    result.compared = false;
    return result;
  }
  const Recording recording = record(scene, 0.0, 0);
  result.certain = recording.certainty.certain;
  result.count = recording.count;
  result.truth = truth.count;
  result.endless = truth.endless;
  if (scene.rule == CountRule::impacts) {
    match(faster(recording.impacts, scene.slowest), faster(truth.impacts, scene.slowest), result);
  } else {
    match(counted(recording.peaks, scene), counted(truth.maxima, scene), result);
  }
  return result;
}

}  // namespace ricochet::carrier_track::inline oracle
