#include "src/report/polyline.h"

namespace ricochet::report {

bool same_height(const Sample& a, const Sample& b) {
  if (a.value != b.value || a.spread.has_value() != b.spread.has_value()) return false;
  return !a.spread || (a.spread->lower == b.spread->lower && a.spread->upper == b.spread->upper);
}

namespace {

/// Whether a line is the same without its sample i: it is level before and after.
bool is_needless(const Series& series, std::size_t i) {
  const auto& samples = series.samples;
  return series.mark == Mark::line && i > 0 && i + 1 < samples.size() &&
         same_height(samples[i - 1], samples[i]) && same_height(samples[i], samples[i + 1]);
}

}  // namespace

std::vector<std::vector<Sample>> polylines(const Series& series) {
  std::vector<std::vector<Sample>> parts;
  const bool steps = series.mark == Mark::steps;
  bool joined = false;
  for (std::size_t i = 0; i < series.samples.size(); ++i) {
    if (is_needless(series, i)) continue;
    const Sample& sample = series.samples[i];
    if (joined && steps) {
      // The last value holds until here, even where here the value is unknown.
      const Sample last = parts.back().back();
      const bool ends = i + 1 == series.samples.size();
      if (same_height(last, sample) && !ends) continue;
      parts.back().push_back({sample.position, last.value, last.spread});
      if (same_height(last, sample)) continue;
    }
    if (!sample.value) {
      joined = false;
      continue;
    }
    if (!joined) parts.emplace_back();
    parts.back().push_back(sample);
    joined = true;
  }
  return parts;
}

}  // namespace ricochet::report
