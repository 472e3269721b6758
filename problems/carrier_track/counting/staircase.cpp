#include "problems/carrier_track/counting/staircase.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "problems/carrier_track/counting/count_scan.h"
#include "problems/carrier_track/counting/threshold.h"
#include "ricochet/machine.h"

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

namespace {

/// The median; for an even number of counts the upper of the two middle ones, so that it is one of
/// the counts.
int middle_count(std::vector<int> counts) {
  const auto middle = counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 2);
  std::nth_element(counts.begin(), middle, counts.end());
  return *middle;
}

/// The number of counts before the best split into counts <= `limit` and counts > `limit`.
double speeds_before(const std::vector<int>& counts, int limit) {
  // With a quiet speed first and a loud one last, a split always exists.
  SpeedScan closed{1, {std::numeric_limits<int>::min()}};
  closed.counts.insert(closed.counts.end(), counts.begin(), counts.end());
  closed.counts.push_back(std::numeric_limits<int>::max());
  return *best_split(closed, limit).speed - 1.5;
}

}  // namespace

std::optional<StepSharpness> step_sharpness(const SpeedScan& scan, double threshold, double limit,
                                            double reach) {
  std::vector<int> below, above;
  for (std::size_t k = 0; k < scan.counts.size(); ++k) {
    const double omega = scan.omega(k);
    if (omega < threshold / reach || omega > threshold * reach) continue;
    (omega < threshold ? below : above).push_back(scan.counts[k]);
  }
  if (below.empty() || above.empty()) return std::nullopt;

  StepSharpness result{threshold, middle_count(below), middle_count(above), 0, 0, Rise::none};
  const auto loud =
      std::count_if(above.begin(), above.end(), [&](int count) { return count > limit; });
  result.persistence = static_cast<double>(loud) / static_cast<double>(above.size());

  std::vector<int> both = below;
  both.insert(both.end(), above.begin(), above.end());
  result.width = scan.step * std::max(0.0, speeds_before(both, result.after - 1) -
                                               speeds_before(both, result.before));

  if (result.persistence >= least_persistence) {
    const bool sharp = result.after >= quiet_limit(result.before) && result.after > result.before &&
                       result.width <= widest_step * threshold;
    result.rise = sharp ? Rise::step : Rise::climb;
  }
  return result;
}

namespace {

/// The largest step, as a share of the speed, and in rad/s.
constexpr double widest_share = 0.05;
constexpr double widest = 0.05;

class Scan {
 public:
  Scan(const Scene& scene, const CompleteScanOptions& options) : scene_(scene), options_(options) {}

  /// Returns false if it takes too many simulations.
  bool cover(double lowest, double highest) {
    MotionSketch here = sketch(lowest);
    add(here);
    constexpr double head_start = 500;
    while (here.omega() < highest) {
      const double step = std::min(widest, widest_share * here.omega());
      const double done = (here.omega() + step - lowest) / (highest - lowest);
      allowed_ = static_cast<std::int64_t>(head_start + done * static_cast<double>(options_.most));
      MotionSketch next = sketch(std::min(highest, here.omega() + step));
      if (!join(here, next)) return false;
      here = std::move(next);
    }
    return true;
  }

  CompleteScan take() { return std::move(scan_); }

 private:
  MotionSketch sketch(double omega) {
    ++scan_.simulations;
    return MotionSketch(scene_, omega);
  }

  bool join(const MotionSketch& a, const MotionSketch& b) {
    if (a.joins(b)) {
      scan_.pieces.back().to = b.omega();
      return true;
    }
    if (b.omega() - a.omega() <= options_.resolution) {
      add(b);
      return true;
    }
    if (scan_.simulations >= allowed_) return false;
    const MotionSketch middle = sketch((a.omega() + b.omega()) / 2);
    return join(a, middle) && join(middle, b);
  }

  void add(const MotionSketch& at) {
    auto& pieces = scan_.pieces;
    if (!pieces.empty() && pieces.back().count == at.count()) {
      pieces.back().to = at.omega();
    } else {
      pieces.push_back({at.omega(), at.omega(), at.count()});
    }
  }

  const Scene& scene_;
  const CompleteScanOptions& options_;
  std::int64_t allowed_ = 0;  // simulations, up to here
  CompleteScan scan_;
};

}  // namespace

std::optional<CountPiece> CompleteScan::first_above(double limit) const {
  for (const CountPiece& piece : pieces) {
    if (piece.count > limit) return piece;
  }
  return std::nullopt;
}

std::optional<CompleteScan> scan_completely(const Scene& scene, double lowest, double highest,
                                            const CompleteScanOptions& options) {
  if (!suits_lanes(at_speed(scene, lowest))) {
    throw std::invalid_argument("only impacts on hard walls at constant speed can be scanned so");
  }
  Scan scan(scene, options);
  if (!scan.cover(lowest, highest)) return std::nullopt;
  return scan.take();
}

std::vector<QuietInterval> quiet_intervals(const SpeedScan& scan, double limit) {
  std::vector<QuietInterval> quiet_intervals;
  bool within = false;
  for (std::size_t k = 0; k < scan.counts.size(); ++k) {
    const bool quiet = scan.counts[k] <= limit;
    if (quiet && !within) quiet_intervals.push_back({scan.omega(k), scan.omega(k)});
    if (quiet) quiet_intervals.back().to = scan.omega(k);
    within = quiet;
  }
  return quiet_intervals;
}

namespace {

constexpr double longest_part = 0.25;     // [rad/s], of a part that is scanned at once
constexpr double shortest_part = 0.0625;  // [rad/s], parts that fail are halved down to this
constexpr CompleteScanOptions part_options{1e-6, 500};

/// Adds a range that touches the last one to it.
void hold(std::vector<CoordinateRange>& ranges, CoordinateRange range) {
  if (!ranges.empty() && range.from <= ranges.back().to + 2 * part_options.resolution) {
    ranges.back().to = range.to;
  } else {
    ranges.push_back(range);
  }
}

void search_part(const Scene& scene, CoordinateRange part, double most,
                 std::vector<CoordinateRange>& ranges) {
  if (const auto scan = scan_completely(scene, part.from, part.to, part_options)) {
    for (const CountPiece& piece : scan->pieces) {
      if (piece.count <= most) hold(ranges, {piece.from, piece.to});
    }
  } else if (part.to - part.from < 1.5 * shortest_part) {
    hold(ranges, part);
  } else {
    const double middle = (part.from + part.to) / 2;
    search_part(scene, {part.from, middle}, most, ranges);
    search_part(scene, {middle, part.to}, most, ranges);
  }
}

}  // namespace

std::vector<CoordinateRange> not_excluded(const Scene& scene, double lowest, double highest,
                                          double most) {
  std::vector<CoordinateRange> ranges;
  for (double from = lowest; from < highest; from += longest_part) {
    search_part(scene, {from, std::min(from + longest_part, highest)}, most, ranges);
  }
  return ranges;
}

}  // namespace ricochet::carrier_track::inline counting
