#include "src/studies/surrogate/charts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ricochet::studies::surrogate {

report::Chart large_chart(std::string name, report::Axis x, report::Axis y) {
  report::Chart chart{std::move(name), "", std::move(x), std::move(y)};
  chart.width = 640;
  chart.height = 420;
  return chart;
}

void add(report::Chart& chart, report::Series series) {
  if (!series.samples.empty()) chart.series.push_back(std::move(series));
}

report::Series tail_of(std::string label, const std::vector<double>& rising) {
  report::Series series{std::move(label), report::Mark::line, {}};
  for (int k = 0; k <= 64; ++k) {
    const double limit = 1e-16 * std::pow(10.0, 0.25 * k);
    const std::size_t larger = larger_than(limit, rising);
    if (larger == 0) break;
    series.samples.push_back(
        {limit, static_cast<double>(larger) / static_cast<double>(rising.size())});
  }
  return series;
}

std::size_t larger_than(double limit, const std::vector<double>& rising) {
  return static_cast<std::size_t>(rising.end() -
                                  std::upper_bound(rising.begin(), rising.end(), limit));
}

}  // namespace ricochet::studies::surrogate
