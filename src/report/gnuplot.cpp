#include "src/report/gnuplot.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <stdexcept>

#include "src/report/process.h"
#include "src/report/script.h"
#include "src/report/svg.h"

namespace ricochet::report {

std::string to_svg(const Chart& chart) {
  check(chart);
  // Without the user's own settings: they would change how a chart looks.
  const ProcessResult result = run_process({"gnuplot", "--default-settings"}, gnuplot_script(chart),
                                           std::chrono::minutes(1));
  if (result.status != 0 || result.output.find("</svg>") == std::string::npos)
    throw std::runtime_error(
        fmt::format("chart {}: gnuplot (package gnuplot-nox) ended with exit code {}: {}",
                    chart.name, result.status, result.errors));
  return finish_svg(result.output, chart.name, chart.title, description(chart));
}

std::vector<std::string> to_svgs(const std::vector<Chart>& charts) {
  std::vector<std::string> svgs(charts.size());
  tbb::parallel_for(std::size_t{0}, charts.size(),
                    [&](std::size_t i) { svgs[i] = to_svg(charts[i]); });
  return svgs;
}

}  // namespace ricochet::report
