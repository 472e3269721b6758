#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "problems/carrier_track/identification/knock_record.h"

namespace ricochet::carrier_track::inline identification {

namespace {

constexpr double longest_delay = 0.05;  // [s], of an echo
constexpr double window = 0.6e-3;       // [s], in which the delays of an echo are
constexpr double fewest_echoes = 0.15;  // over the number of knocks
constexpr double sharpest_peak = 5;     // delays in the window over those expected from beside it
// Without strengths the pairs of an impact and the echo of another cannot be left out.
constexpr double sharpest_without = 2.5;
constexpr double fewest_followed = 0.45;  // of the knocks that are no echoes
constexpr double same_ratio = 0.35;       // of logarithms of the ratio of strengths
constexpr double steady = 1.05;           // highest over lowest speed, at most
constexpr int most_echoes = 5;
constexpr std::size_t most_pairs = 2'000'000;  // of denser records no echo is looked for

void merge_duplicates(KnockRecord& record) {
  std::vector<Knock> merged;
  for (const Knock& knock : record.knocks) {
    if (merged.empty() || knock.time > merged.back().time) {
      merged.push_back(knock);
    } else if (knock.strength > merged.back().strength) {
      merged.back() = knock;
    }
  }
  const std::size_t twice = record.knocks.size() - merged.size();
  if (twice == 0) return;
  record.notes.push_back(fmt::format(
      "{} rows have the time of the row before: of each time the strongest knock is kept.", twice));
  record.knocks = std::move(merged);
}

struct Pair {
  double delay;
  double ratio;  ///< ln of the strength over that of the knock before; 0 without strengths
  std::size_t second;
};

std::vector<Pair> pairs_of(const std::vector<Knock>& knocks) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < knocks.size(); ++i) {
    for (std::size_t j = i + 1; j < knocks.size(); ++j) {
      const double delay = knocks[j].time - knocks[i].time;
      if (delay > longest_delay) break;
      const double ratio =
          knocks[i].strength ? std::log(*knocks[j].strength / *knocks[i].strength) : 0;
      pairs.push_back({delay, ratio, j});
      if (pairs.size() > most_pairs) return {};
    }
  }
  std::ranges::sort(pairs, {}, &Pair::delay);
  return pairs;
}

double median(std::vector<Pair>& pairs, double Pair::*number) {
  const auto middle = pairs.begin() + std::ssize(pairs) / 2;
  std::ranges::nth_element(pairs, middle, {}, number);
  return (*middle).*number;
}

/// The pairs of the sharpest peak among the delays, if it is an echo's: more than rebounds give.
std::vector<Pair> echo_among(const std::vector<Pair>& pairs, const KnockRecord& record) {
  const auto from = [&](double delay) {
    return std::ranges::lower_bound(pairs, delay, {}, &Pair::delay);
  };
  auto peak = std::pair(pairs.begin(), pairs.begin());
  for (auto first = pairs.begin(); first != pairs.end(); ++first) {
    const auto last = from(first->delay + window);
    if (last - first > peak.second - peak.first) peak = {first, last};
  }
  std::vector<Pair> most(peak.first, peak.second);
  if (most.empty()) return {};
  const double ratio = median(most, &Pair::ratio);
  const auto is_alike = [&](const Pair& p) { return std::abs(p.ratio - ratio) <= same_ratio; };
  const double begin = std::ranges::min(most, {}, &Pair::delay).delay;
  std::erase_if(most, [&](const Pair& p) { return !is_alike(p); });
  // Delays beside the peak, in windows as wide as it; none are shorter than 0.
  const double below = std::min(5 * window, begin);
  const auto beside =
      static_cast<double>(std::count_if(from(begin - below), from(begin), is_alike) +
                          std::count_if(from(begin + window), from(begin + 6 * window), is_alike));
  const double expected = beside * window / (below + 5 * window);
  const auto found = static_cast<double>(most.size());
  if (found < fewest_echoes * static_cast<double>(record.knocks.size())) return {};
  if (found < (record.has_strengths() ? sharpest_peak : sharpest_without) * (expected + 1)) {
    return {};
  }
  // An echo's delays are as sharp as the times are written: what is farther off are impacts.
  const double delay = median(most, &Pair::delay);
  for (Pair& pair : most) pair.delay = std::abs(pair.delay - delay);
  const double spread = std::max(3 * median(most, &Pair::delay), 1.5e-4);
  most.clear();
  std::copy_if(from(delay - spread), from(delay + spread), std::back_inserter(most), is_alike);
  return most;
}

/// Returns true if pairs are an echo's, not rebounds: most knocks have it, whatever they are, and
/// its delay does not change with the speed of the plate, as that of rebounds does.
bool is_echo_of(const std::vector<Pair>& echoes, std::size_t others, const KnockRecord& record) {
  const auto n = static_cast<double>(echoes.size());
  if (n < fewest_followed * static_cast<double>(others)) return false;
  const auto [slow, fast] = std::ranges::minmax(record.speed, {}, &SpeedKnot<double>::omega);
  if (fast.omega < steady * slow.omega) return false;
  double sums[5] = {};
  for (const Pair& pair : echoes) {
    const double x = speed_at(record.speed, record.knocks[pair.second].time);
    const double y = 1e3 * (pair.delay - echoes.front().delay);
    const double terms[] = {x, y, x * x, x * y, y * y};
    for (std::size_t k = 0; k < 5; ++k) sums[k] += terms[k] / n;
  }
  const double together = sums[3] - sums[0] * sums[1];
  const double apart = (sums[2] - sums[0] * sums[0]) * (sums[4] - sums[1] * sums[1]);
  // A correlation that chance exceeds once in a thousand times; rounding is none.
  return together * together * n <= 11 * apart + 1e-9;
}

bool take_out_echo(KnockRecord& record) {
  std::vector<Pair> echoes = echo_among(pairs_of(record.knocks), record);
  if (echoes.empty()) return false;
  std::vector<bool> is_echo(record.knocks.size(), false);
  for (const Pair& pair : echoes) is_echo[pair.second] = true;
  const auto removed = static_cast<std::size_t>(std::ranges::count(is_echo, true));
  const double delay = 1e3 * median(echoes, &Pair::delay);
  if (!is_echo_of(echoes, record.knocks.size() - removed, record)) {
    record.notes.push_back(fmt::format(
        "{} knocks follow another after {:.3g} ms: they are taken for rebounds, and may be "
        "echoes of the sensor. Change the speed by more, or record strengths.",
        echoes.size(), delay));
    return false;
  }
  record.notes.push_back(fmt::format(
      "{} knocks are echoes of the sensor and are left out: each follows another after {:.3g} "
      "ms{}.",
      removed, delay,
      record.has_strengths() ? fmt::format(", at {:.0f} % of its strength",
                                           100 * std::exp(median(echoes, &Pair::ratio)))
                             : ""));
  std::vector<Knock> kept;
  for (std::size_t i = 0; i < is_echo.size(); ++i) {
    if (!is_echo[i]) kept.push_back(record.knocks[i]);
  }
  record.knocks = std::move(kept);
  return true;
}

void find_saturation(KnockRecord& record) {
  if (!record.has_strengths()) return;
  const double most = *std::ranges::max(record.knocks, {}, &Knock::strength).strength;
  const auto equal =
      std::ranges::count_if(record.knocks, [&](const Knock& k) { return *k.strength == most; });
  if (equal < 3 || 100 * static_cast<std::size_t>(equal) < record.knocks.size()) return;
  record.saturation = most;
  record.notes.push_back(fmt::format(
      "{} knocks have the largest strength, {:.4g}: the sensor is taken to saturate there.", equal,
      most));
}

}  // namespace

void take_out_sensor_faults(KnockRecord& record) {
  merge_duplicates(record);
  for (int k = 0; k < most_echoes && take_out_echo(record); ++k) {
  }
  find_saturation(record);
  // The most likely dead time is the longest that no interval contradicts.
  record.dead_time = longest_delay;
  for (std::size_t i = 1; i < record.knocks.size(); ++i) {
    record.dead_time =
        std::min(record.dead_time, record.knocks[i].time - record.knocks[i - 1].time);
  }
}

}  // namespace ricochet::carrier_track::inline identification
