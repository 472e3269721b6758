#include "src/site/front_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "src/site/pairs.h"

namespace ricochet::site {
namespace {

using report::Chart;
using report::Json;
using report::Mark;
using report::Sample;
using report::Scale;
using report::Series;

constexpr int width = 520, height = 360;

std::string file_name(std::string text) {
  for (char& c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (!plain) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : '-';
  }
  return text;
}

/// A row of the contest by the names of its columns.
class Row {
 public:
  Row(const std::map<std::string, std::size_t>& columns, const Json& values)
      : columns_(columns), values_(values) {}
  const Json& operator[](const std::string& column) const {
    return values_.at(columns_.at(column));
  }

 private:
  const std::map<std::string, std::size_t>& columns_;
  const Json& values_;
};

/// Whether another one is as fast and as good, and better in one.
bool is_beaten(const Sample& sample, const std::vector<Sample>& all) {
  return std::any_of(all.begin(), all.end(), [&](const Sample& other) {
    return other.position <= sample.position && *other.value >= *sample.value &&
           (other.position < sample.position || *other.value > *sample.value);
  });
}

/// One family with its largest budget.
Chart competitor_chart(const Json& contest, std::size_t family) {
  std::map<std::string, std::size_t> columns;
  for (const Json& name : contest.at("columns")) {
    columns.emplace(name.get<std::string>(), columns.size());
  }
  double budget = 0;
  for (const Json& values : contest.at("rows")) {
    const Row row(columns, values);
    if (row["family"] == family) budget = std::max(budget, row["budget"].get<double>());
  }
  const auto& name = contest.at("families").at(family).at("name").get_ref<const std::string&>();
  Chart chart{.name = "front-" + file_name(name),
              .title = budget == 0 ? "All families, with the largest budgets"
                                   : fmt::format("{}: {} evaluations a variable", name, budget),
              .x = {"evaluations for each variable", Scale::logarithmic},
              .y = {"runs solved [%]", Scale::linear, report::Range{0, 100}},
              .width = width,
              .height = height};
  std::vector<Series> dots;
  std::vector<Sample> places;
  for (const Json& values : contest.at("rows")) {
    const Row row(columns, values);
    if (row["family"] != family || row["budget"] != budget || !row["complete"].get<bool>())
      continue;
    const Json &x = row["evaluations"], &y = row["solved"];
    if (!x.is_number() || x.get<double>() <= 0 || !y.is_number()) continue;
    places.push_back({x, 100 * y.get<double>()});
    dots.push_back(
        {fmt::format("{}, {}", row["solver"].get<std::string>(), row["form"].get<std::string>()),
         Mark::points,
         {places.back()}});
  }
  Series dominated{"others", Mark::points, {}};
  for (Series& dot : dots) {
    if (is_beaten(dot.samples.front(), places)) {
      dominated.samples.push_back(dot.samples.front());
    } else {
      chart.series.push_back(std::move(dot));
    }
  }
  if (!dominated.samples.empty()) chart.series.push_back(std::move(dominated));
  return chart;
}

Chart motion_chart(const Json& view) {
  const bool logarithmic = view.at("y_logarithmic").get<bool>();
  Chart chart{.name = "front-" + file_name(view.at("id")),
              .title = view.at("name"),
              .x = {view.at("x"), Scale::logarithmic},
              .y = {view.at("y"), logarithmic ? Scale::logarithmic : Scale::linear},
              .width = width,
              .height = height};
  for (const Json& one : view.at("series")) {
    Series series{one.at("name"), Mark::points, {}};
    for (const Json& point : one.at("points")) {
      if (!point.at(0).is_number() || !point.at(1).is_number()) continue;
      series.samples.push_back({point[0], point[1].get<double>()});
    }
    if (!series.samples.empty()) chart.series.push_back(std::move(series));
  }
  return chart;
}

/// Of each simulation the pair with the solver that is fastest there, as all that lead are; the
/// others lie to its right.
Chart pairs_chart(const Json& data) {
  const std::vector<SolverSimulation> pairs = pairs_of(data), front = front_of_pairs(pairs);
  Chart chart{
      .name = "front-solver-and-simulation",
      .title = pairs_title(data),
      .x = {"processor time to the threshold, with the fastest solver [s]", Scale::logarithmic},
      .y = {"error of the threshold, at most [rad/s]", Scale::logarithmic},
      .width = 780,
      .height = 420,
      .description = pairs_finding(data)};
  Series line{.label = "none is as fast and as accurate", .mark = Mark::steps, .samples = {}};
  for (const SolverSimulation& pair : front) line.samples.push_back({pair.seconds, pair.error});
  if (front.size() > 1) chart.series.push_back(std::move(line));
  for (std::size_t m = 0; m < data.at("simulations").size(); ++m) {
    const std::string name = data["simulations"][m].at("name");
    if (m == 0 || data["simulations"][m - 1]["name"] != name) {
      chart.series.push_back({.label = name, .mark = Mark::points, .samples = {}});
    }
    const SolverSimulation* fastest = nullptr;
    for (const SolverSimulation& pair : pairs) {
      if (pair.simulation != m) continue;
      if (fastest == nullptr || pair.seconds < fastest->seconds) fastest = &pair;
    }
    const bool leads = std::any_of(front.begin(), front.end(), [&](const SolverSimulation& pair) {
      return pair.simulation == m;
    });
    Sample dot{fastest->seconds, fastest->error};
    if (leads) dot.name = name_of_pair(data, *fastest);
    chart.series.back().samples.push_back(std::move(dot));
  }
  return chart;
}

}  // namespace

std::vector<Chart> front_charts(const Json& data) {
  std::vector<Chart> charts;
  if (const Json& contest = data.at("contest"); !contest.is_null()) {
    for (std::size_t family = 0; family < contest.at("families").size(); ++family) {
      charts.push_back(competitor_chart(contest, family));
    }
  }
  if (const Json& motion = data.at("motion"); !motion.is_null()) {
    charts.push_back(motion_chart(motion.at("views").front()));
  }
  if (const Json& pairs = data.at("pairs"); !pairs.is_null()) charts.push_back(pairs_chart(pairs));
  std::erase_if(charts, [](const Chart& chart) { return chart.series.empty(); });
  return charts;
}

}  // namespace ricochet::site
