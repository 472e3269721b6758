#include "src/report/end_labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/report/quote.h"

namespace ricochet::report {
namespace {

constexpr double line_height = 14;  // pixels
constexpr double beside = 4;     // pixels, from a curve's end up to a label that no line leads to
constexpr double farthest = 45;  // up to one that a line leads to
constexpr int leader = 18;       // pixels, across
constexpr std::size_t most = 6;  // more of them are read more easily in a legend
constexpr double widest_share = 0.45;  // of the chart's width, for the labels
constexpr double right_end = 0.97;     // of the plot's width: a curve ends at the right

double share(double value, const Range& range, Scale scale) {
  if (scale == Scale::linear) return (value - range.lower) / (range.upper - range.lower);
  return std::log(value / range.lower) / std::log(range.upper / range.lower);
}

/// Labels that follow each other at their least distance, in the middle of where they should be.
struct Cluster {
  std::size_t first, last;
  double sum = 0;  ///< of where its labels should be, were they all at its lowest place

  double lowest(double distance, double top) const {
    const auto many = static_cast<double>(last - first + 1);
    return std::clamp(sum / many, 0.0, std::max(0.0, top - (many - 1) * distance));
  }
};

/// Moves labels, which are in order, to places at least the distance apart, by as little as it
/// takes.
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

std::vector<EndLabel> end_labels(const Chart& chart, const Frame& frame) {
  const double height = plot_height(chart);
  std::vector<EndLabel> labels;
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const Series& series = chart.series[i];
    if (series.label.empty()) continue;
    if (series.mark == Mark::points || series.samples.empty()) return {};
    const Sample& last = series.samples.back();
    if (!last.value || share(last.position, frame.x, chart.x.scale) < right_end) return {};
    const double end = share(*last.value, frame.y, chart.y.scale);
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

bool need_leaders(const Chart& chart, const std::vector<EndLabel>& labels) {
  return std::ranges::any_of(labels, [&](const EndLabel& label) {
    return std::abs(label.place - label.end) > beside / plot_height(chart);
  });
}

int room_for(const Chart& chart, const std::vector<EndLabel>& labels) {
  int widest = 0;
  for (const EndLabel& label : labels) widest = std::max(widest, text_width(label.text));
  if (labels.empty()) return 0;
  return widest + 15 + (need_leaders(chart, labels) ? leader : 0);
}

std::string end_label_script(const Chart& chart, const std::vector<EndLabel>& labels,
                             const std::vector<std::string>& colours) {
  const bool led = need_leaders(chart, labels);
  const double edge = chart.width - room_for(chart, labels);
  const auto at = [&](double pixels) { return fmt::format("{:.5f}", pixels / chart.width); };
  std::string script;
  for (const EndLabel& label : labels) {
    script += fmt::format("set label {} at screen {}, graph {:.4f} left offset 0.7,0\n",
                          quoted(label.text), at(edge + (led ? leader : 0)), label.place);
    if (!led) continue;
    script += fmt::format(
        "set arrow from screen {}, graph {:.4f} to screen {}, graph {:.4f} nohead lw 1 lc rgb "
        "'{}'\n",
        at(edge + 2), label.end, at(edge + leader), label.place, colours.at(label.series));
  }
  return script;
}

}  // namespace ricochet::report
