#include "src/report/end_labels.h"

#include <algorithm>
#include <cmath>

#include "src/report/ticks.h"
#include "src/report/wrapped.h"

namespace ricochet::report {
namespace {

constexpr double line_height = 14;  // pixels
constexpr double beside = 4;        // pixels, from a curve's end to a label without a leader line
constexpr double farthest = 45;     // to a label with a leader line
constexpr std::size_t most = 6;     // with more labels a legend is easier to read
constexpr double widest_share = 0.45;  // of the chart's width, for the labels
constexpr double right_end = 0.97;     // of the plot's width: a curve ends at the right

/// Labels at the least distance from each other, centred around where they should be.
struct Cluster {
  std::size_t first, last;
  double sum = 0;  ///< sum of where its labels should be, relative to the lowest place

  double lowest(double distance, double top) const {
    const auto many = static_cast<double>(last - first + 1);
    return std::clamp(sum / many, 0.0, std::max(0.0, top - (many - 1) * distance));
  }
};

/// Moves sorted labels apart to at least this distance, with the least total displacement.
void move_apart(std::vector<EndLabel>& labels, double distance) {
  std::vector<Cluster> clusters;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    clusters.push_back({i, i, labels[i].end});
    while (clusters.size() > 1) {
      Cluster& below = clusters[clusters.size() - 2];
      const Cluster above = clusters.back();
      const auto many = static_cast<double>(below.last - below.first + 1);
      const double next = below.lowest(distance, 1) + many * distance;
      if (above.lowest(distance, 1) >= next) break;
      const auto added = static_cast<double>(above.last - above.first + 1);
      below.sum += above.sum - added * many * distance;
      below.last = above.last;
      clusters.pop_back();
    }
  }
  for (const Cluster& cluster : clusters) {
    for (std::size_t i = cluster.first; i <= cluster.last; ++i) {
      labels[i].place =
          cluster.lowest(distance, 1) + static_cast<double>(i - cluster.first) * distance;
    }
  }
}

}  // namespace

std::vector<EndLabel> end_labels(const Chart& chart, const Range& x, const Range& y,
                                 double height) {
  std::vector<EndLabel> labels;
  if (!chart.areas.empty()) return {};  // which need a legend, with the series in it
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const Series& series = chart.series[i];
    if (series.label.empty()) continue;
    if (series.mark == Mark::points || series.samples.empty()) return {};
    const Sample& last = series.samples.back();
    if (!last.value || share(last.position, x, chart.x.scale) < right_end) return {};
    const double end = share(*last.value, y, chart.y.scale);
    if (end < 0 || end > 1) return {};
    if (text_width(series.label) > widest_share * chart.width) return {};
    labels.push_back({series.label, i, end, end});
  }
  if (labels.size() < 2 || labels.size() > most) return {};
  std::stable_sort(labels.begin(), labels.end(),
                   [](const EndLabel& a, const EndLabel& b) { return a.end < b.end; });
  move_apart(labels, line_height / height);
  for (const EndLabel& label : labels) {
    if (std::abs(label.place - label.end) > farthest / height) return {};
  }
  return labels;
}

bool need_leaders(const std::vector<EndLabel>& labels, double height) {
  return std::ranges::any_of(labels, [&](const EndLabel& label) {
    return std::abs(label.place - label.end) > beside / height;
  });
}

}  // namespace ricochet::report
