#include "src/report/end_labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/report/quote.h"

namespace ricochet::report {
namespace {

constexpr double line_height = 14;     // pixels
constexpr double farthest = 10;        // pixels, from a curve's end up to its label
constexpr double widest_share = 0.45;  // of the chart's width, for the labels
constexpr double right_end = 0.97;     // of the plot's width: a curve ends at the right

double share(double value, const Range& range, Scale scale) {
  if (scale == Scale::linear) return (value - range.lower) / (range.upper - range.lower);
  return std::log(value / range.lower) / std::log(range.upper / range.lower);
}

}  // namespace

std::vector<EndLabel> end_labels(const Chart& chart, const Frame& frame) {
  const double height = plot_height(chart);
  std::vector<EndLabel> labels;
  for (const Series& series : chart.series) {
    if (series.label.empty()) continue;
    if (series.mark == Mark::points || series.samples.empty()) return {};
    const Sample& last = series.samples.back();
    if (!last.value || share(last.position, frame.x, chart.x.scale) < right_end) return {};
    const double place = share(*last.value, frame.y, chart.y.scale);
    if (place < 0 || place > 1) return {};
    if (text_width(series.label) > widest_share * chart.width) return {};
    labels.push_back({series.label, *last.value, place});
  }
  if (labels.size() < 2) return {};
  std::stable_sort(labels.begin(), labels.end(),
                   [](const EndLabel& a, const EndLabel& b) { return a.place < b.place; });
  // Each above the one before, not too far from its curve.
  std::vector<double> places;
  for (const EndLabel& label : labels) {
    const double least = places.empty() ? 0 : places.back() + line_height / height;
    places.push_back(std::max(label.place, least));
  }
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (places[i] - labels[i].place > farthest / height) return {};
    labels[i].place = places[i];
  }
  return labels;
}

std::string end_label_script(const std::vector<EndLabel>& labels) {
  std::string script;
  for (const EndLabel& label : labels) {
    script += fmt::format("set label {} at graph 1, graph {:.4f} left offset 0.7,0\n",
                          quoted(label.text), label.place);
  }
  return script;
}

}  // namespace ricochet::report
