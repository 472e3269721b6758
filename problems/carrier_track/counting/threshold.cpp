#include "problems/carrier_track/counting/threshold.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <span>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/count_scan.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track::inline counting {

namespace {

double median(std::vector<int> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  const double upper = *middle;
  if (values.size() % 2 == 1) return upper;
  return (upper + *std::max_element(values.begin(), middle)) / 2;
}

/// The counts of the scanned speeds that `chosen(omega)` picks.
template <class Predicate>
std::vector<int> counts_where(const SpeedScan& scan, Predicate chosen) {
  std::vector<int> counts;
  for (std::size_t k = 0; k < scan.counts.size(); ++k) {
    if (chosen(scan.omega(k))) counts.push_back(scan.counts[k]);
  }
  return counts;
}

template <class Predicate>
double share(std::size_t size, Predicate holds) {
  std::size_t held = 0;
  for (std::size_t k = 0; k < size; ++k) held += holds(k) ? 1 : 0;
  return static_cast<double>(held) / static_cast<double>(size);
}

/// Returns true if omega is below the reference. A multiple of the step that equals the reference
/// except for rounding is neither below nor above it.
bool is_below(double omega, double reference) {
  return omega < reference * (1 - 1e-9);
}

double reference_of(const Claim& claim, double highest) {
  return claim.threshold.value_or(quiet_share * highest);
}

int most_common_below(const SpeedScan& scan, double reference) {
  const auto below = counts_where(scan, [&](double w) { return is_below(w, reference); });
  return most_common(below).value_or(scan.counts.front());
}

std::vector<Example> judge_examples(const CountAt& count_at, const Figure& figure, double limit) {
  std::vector<Example> examples;
  for (const bool loud : {false, true}) {
    const double omega = loud ? figure.loud : figure.quiet;
    const int count = count_at(omega);
    examples.push_back({omega, loud, count, (count > limit) == loud});
  }
  return examples;
}

/// Scans in parallel, in blocks of neighbouring speeds, as many of the slowest as there is time
/// for.
template <class CountsAt>
SpeedScan scan_in_blocks(double step, double highest, const CountsAt& counts_at) {
  SpeedScan scan{step, std::vector<int>(static_cast<std::size_t>(std::llround(highest / step)))};
  scan.counts.resize(count_in_blocks(scan, counts_at));
  return scan;
}

SpeedScan whole(SpeedScan scan, double highest) {
  if (!extends_to(scan, highest)) throw TimeLimitReached();
  return scan;
}

/// Keeps a reference to the scene.
CountAt counts_of(const Scene& scene) {
  return [&scene](double omega) { return count_at(scene, omega); };
}

}  // namespace

int count_at(const Scene& scene, double omega) {
  return static_cast<int>(objective(at_speed(scene, omega), 0.0));
}

bool extends_to(const SpeedScan& scan, double highest) {
  return scan.counts.size() >= static_cast<std::size_t>(std::llround(highest / scan.step));
}

SpeedScan scan_slowest_speeds(const CountAt& count, double step, double highest) {
  return scan_in_blocks(step, highest, [&](std::span<const double> speeds) {
    std::vector<int> counts;
    for (const double omega : speeds) counts.push_back(count(omega));
    return counts;
  });
}

SpeedScan scan_slowest_speeds(const Scene& scene, double step, double highest) {
  return scan_in_blocks(step, highest,
                        [&](std::span<const double> speeds) { return counts_at(scene, speeds); });
}

SpeedScan scan_speeds(const CountAt& count, double step, double highest) {
  return whole(scan_slowest_speeds(count, step, highest), highest);
}

SpeedScan scan_speeds(const Scene& scene, double step, double highest) {
  return whole(scan_slowest_speeds(scene, step, highest), highest);
}

SpeedScan thinned(const SpeedScan& scan, std::size_t stride) {
  SpeedScan result{scan.step * static_cast<double>(stride), {}};
  for (std::size_t k = stride; k <= scan.counts.size(); k += stride) {
    result.counts.push_back(scan.counts[k - 1]);
  }
  return result;
}

Split best_split(const SpeedScan& scan, double limit) {
  const std::size_t size = scan.counts.size();
  Split split;
  // Starts with all speeds called loud, then calls one speed after the other quiet.
  auto wrong = static_cast<std::size_t>(
      std::count_if(scan.counts.begin(), scan.counts.end(), [&](int c) { return c <= limit; }));
  std::size_t best = wrong;
  std::size_t quiet_speeds = 0;
  for (std::size_t k = 0; k < size; ++k) {
    const bool loud = scan.counts[k] > limit;
    if (loud && !split.first_loud) split.first_loud = scan.omega(k);
    wrong = loud ? wrong + 1 : wrong - 1;
    if (wrong < best) {
      best = wrong;
      quiet_speeds = k + 1;
    }
  }
  split.misclassified = static_cast<double>(best) / static_cast<double>(size);
  if (quiet_speeds > 0 && quiet_speeds < size) {
    split.speed = (static_cast<double>(quiet_speeds) + 0.5) * scan.step;
  }
  return split;
}

std::optional<int> most_common(const std::vector<int>& counts) {
  std::map<int, std::size_t> histogram;
  for (const int count : counts) ++histogram[count];
  if (histogram.empty()) return std::nullopt;
  return std::max_element(histogram.begin(), histogram.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

Score score(const CountAt& count, const Claim& claim, const SpeedScan& fine, std::size_t stride) {
  const SpeedScan scan = thinned(fine, stride);
  const double highest = fine.omega(fine.counts.size() - 1);
  Score result;
  result.evaluations = static_cast<std::int64_t>(fine.counts.size());
  result.quiet_count = most_common_below(scan, reference_of(claim, highest));
  const double limit = quiet_limit(result.quiet_count);
  const Split split = best_split(fine, limit);
  result.threshold = split.speed;
  result.first_loud = split.first_loud;
  const double divide = split.speed.value_or(scan.counts.front() > limit ? 0 : 2 * highest);
  result.misclassified = share(scan.counts.size(), [&](std::size_t k) {
    return (scan.counts[k] > limit) != (scan.omega(k) > divide);
  });
  if (const auto reference = claim.threshold ? claim.threshold : split.speed) {
    const auto below = counts_where(scan, [&](double w) { return is_below(w, *reference); });
    const auto above = counts_where(scan, [&](double w) { return is_below(*reference, w); });
    if (!below.empty()) {
      result.purity = share(below.size(), [&](std::size_t k) {
        return std::abs(below[k] - result.quiet_count) <= 1;
      });
    }
    if (!above.empty() && result.quiet_count > 0) {
      result.loudness = median(above) / result.quiet_count;
    }
  }
  if (claim.figure) {
    result.examples = judge_examples(count, *claim.figure, limit);
    result.evaluations += static_cast<std::int64_t>(result.examples.size());
  }
  return result;
}

Score score(const Scene& scene, const Claim& claim, const SpeedScan& fine, std::size_t stride) {
  return score(counts_of(scene), claim, fine, stride);
}

int quiet_count(const Scene& scene, const Claim& claim, const ScanOptions& options) {
  const double reference = reference_of(claim, options.highest);
  const double step = options.step * static_cast<double>(options.stride);
  return most_common_below(scan_speeds(scene, step, std::max(reference, step)), reference);
}

Score score(const Scene& scene, const Claim& claim, const ScanOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const SpeedScan scan = scan_speeds(scene, options.step, options.highest);
  Score result = score(scene, claim, scan, options.stride);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace ricochet::carrier_track::inline counting
