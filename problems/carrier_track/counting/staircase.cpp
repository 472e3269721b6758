#include "problems/carrier_track/counting/staircase.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "problems/carrier_track/counting/count_in_blocks.h"
#include "problems/carrier_track/counting/counts.h"
#include "problems/carrier_track/counting/threshold.h"
#include "ricochet/threshold.h"

namespace ricochet::carrier_track::inline counting {
namespace {

constexpr double per_e_fold = LogarithmicScan::per_e_fold;
constexpr double reaches[] = {1.1, 1.2, 1.35, 1.5, 1.75, 2};

/// The number of speeds of a scan between a speed and `reach` times that speed.
std::size_t speeds_within(double reach) {
  return static_cast<std::size_t>(std::lround(per_e_fold * std::log(reach)));
}

/// The value at index `before` of the sorted values.
int in_order(const int* begin, const int* end, std::size_t before) {
  std::vector<int> values(begin, end);
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(before);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// A step between the speeds k - 1 and k of the scan.
struct Candidate {
  std::size_t k = 0;
  std::size_t width = 0;  ///< speeds within reach, on either side
  Step step{};
};

/// The most significant step there; significance 0 if there is none.
Candidate candidate_at(const LogarithmicScan& scan, std::size_t k) {
  Candidate best;
  for (const double reach : reaches) {
    const std::size_t width = speeds_within(reach);
    if (k < width || k + width > scan.counts.size()) break;
    const int* const here = scan.counts.data() + k;
    const std::size_t tenth = width / 10;
    const int below = in_order(here - width, here, width - 1 - tenth);
    const int above = in_order(here, here + width, tenth);
    if (2 * above < 3 * below || above < below + 2) continue;
    const double significance = std::log((1.0 + above) / (1.0 + below)) * std::log(reach);
    if (significance > best.step.significance) {
      best = {k, width, {0, below, above, reach, 0, significance}};
    }
  }
  return best;
}

/// Moves the step to where the speeds within its reach divide best.
void divide_best(const LogarithmicScan& scan, Candidate& candidate) {
  auto& [k, width, step] = candidate;
  const auto at = scan.counts.begin() + static_cast<std::ptrdiff_t>(k);
  const auto reach = static_cast<std::ptrdiff_t>(width);
  // By index instead of by speed. A split exists because nine tenths of either half are on their
  // side.
  const Split split = best_split(SpeedScan{1, {at - reach, at + reach}}, step.limit());
  k = k - width + static_cast<std::size_t>(split.speed.value());
  step.misclassified = split.misclassified;
  step.omega = std::sqrt(scan.omega(k - 1) * scan.omega(k));
}

Level level_of(const LogarithmicScan& scan, std::size_t begin, std::size_t end) {
  const int* const first = scan.counts.data() + begin;
  const int* const last = scan.counts.data() + end;
  const std::size_t size = end - begin;
  return {scan.omega(begin), scan.omega(end - 1), in_order(first, last, size / 10),
          in_order(first, last, size / 2), in_order(first, last, size - 1 - size / 10)};
}

/// Scans in parallel, in blocks of neighbouring speeds.
template <class CountsAt>
LogarithmicScan scan_logarithmic_blocks(double lowest, double highest, const CountsAt& counts_at) {
  LogarithmicScan scan;
  scan.first = static_cast<int>(std::ceil(per_e_fold * std::log(lowest)));
  const int last = static_cast<int>(std::floor(per_e_fold * std::log(highest)));
  scan.counts.resize(static_cast<std::size_t>(std::max(0, last - scan.first + 1)));
  if (count_in_blocks(scan, counts_at) < scan.counts.size()) throw TimeLimitReached();
  return scan;
}

}  // namespace

double LogarithmicScan::omega(std::size_t k) const {
  return std::exp((first + static_cast<double>(k)) / per_e_fold);
}

LogarithmicScan scan_logarithmically(const CountAt& count, double lowest, double highest) {
  return scan_logarithmic_blocks(lowest, highest, [&](std::span<const double> speeds) {
    std::vector<int> counts;
    for (const double omega : speeds) counts.push_back(count(omega));
    return counts;
  });
}

LogarithmicScan scan_logarithmically(const Scene& scene, double lowest, double highest) {
  return scan_logarithmic_blocks(
      lowest, highest, [&](std::span<const double> speeds) { return counts_at(scene, speeds); });
}

Staircase staircase_of(const LogarithmicScan& scan, double fastest) {
  std::vector<Candidate> candidates;
  for (std::size_t k = 1; k < scan.counts.size(); ++k) {
    if (scan.counts[k] <= scan.counts[k - 1]) continue;
    const Candidate candidate = candidate_at(scan, k);
    if (candidate.step.significance > 0) candidates.push_back(candidate);
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
    return a.step.significance > b.step.significance;
  });
  // A step within 10 % of a more significant step is part of it.
  const std::size_t near = speeds_within(1.1);
  std::vector<bool> taken(scan.counts.size() + 1);
  std::vector<Candidate> chosen;
  for (Candidate& candidate : candidates) {
    if (taken[candidate.k]) continue;
    const std::size_t found = candidate.k;
    divide_best(scan, candidate);
    for (const std::size_t k : {found, candidate.k}) {
      const std::size_t begin = k > near ? k - near : 0;
      std::fill(taken.begin() + static_cast<std::ptrdiff_t>(begin),
                taken.begin() + static_cast<std::ptrdiff_t>(std::min(k + near, taken.size())),
                true);
    }
    if (candidate.step.omega <= fastest) chosen.push_back(candidate);
  }
  std::sort(chosen.begin(), chosen.end(), [](const auto& a, const auto& b) { return a.k < b.k; });

  Staircase staircase;
  std::size_t begin = 0;
  for (const Candidate& candidate : chosen) {
    staircase.steps.push_back(candidate.step);
    staircase.levels.push_back(level_of(scan, begin, candidate.k));
    begin = candidate.k;
  }
  std::size_t end = begin;
  while (end < scan.counts.size() && scan.omega(end) <= fastest) ++end;
  if (end > begin) staircase.levels.push_back(level_of(scan, begin, end));
  return staircase;
}

std::optional<Step> Staircase::main_step() const {
  const auto highest =
      std::max_element(steps.begin(), steps.end(), [](const Step& a, const Step& b) {
        return a.significance < b.significance;  // the first of equals
      });
  return highest == steps.end() ? std::nullopt : std::optional(*highest);
}

}  // namespace ricochet::carrier_track::inline counting
