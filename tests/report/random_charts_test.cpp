#include "src/report/frame.h"
#include "src/report/svg.h"
#include "tests/report/pictures.h"

namespace ricochet::report {
namespace {

constexpr int charts = 2000;

/// Descriptions of charts that pass their check, ugly ones too.
class RandomCharts {
 public:
  explicit RandomCharts(std::uint64_t seed) : random_(seed) {}

  Chart next() {
    Chart chart{.name = "random", .title = text(), .x = {text()}, .y = {text()}};
    chart.width = whole(1, 1000);
    chart.height = whole(1, 700);
    whole(0, 3) == 0 ? add_heat_map(chart) : add_series(chart);
    return chart;
  }

 private:
  int whole(int from, int to) { return std::uniform_int_distribution<int>(from, to)(random_); }
  bool maybe() { return whole(0, 1) == 1; }

  std::string text() {
    static const std::string parts[] = {
        "a",  "speed [rad/s] ",    "<b>", "&amp;", "'", "\"", "ω²", "]]>", "\xff", "\x02", "%",
        "  ", std::string(35, 'n')};
    std::string text;
    for (int i = whole(0, 8); i > 0; --i) text += parts[whole(0, 12)];
    return text;
  }

  double number(const Axis& axis) {
    static constexpr double sizes[] = {1e-100, 1e-12, 1, 1, 1, 1000, 1e9, 1e100};
    const double size = sizes[whole(0, 7)] * std::uniform_real_distribution<>(0.01, 1)(random_);
    if (axis.scale == Scale::logarithmic) return std::max(size, 1e-100);
    return maybe() ? size : maybe() ? -size : whole(-2, 2);
  }

  void choose(Axis& axis) {
    axis.scale = maybe() ? Scale::linear : Scale::logarithmic;
    if (maybe()) return;
    const double a = number(axis), b = number(axis);
    if (a != b) axis.range = Range{std::min(a, b), std::max(a, b)};
  }

  void add_series(Chart& chart) {
    choose(chart.y);
    if (whole(0, 3) == 0) {
      for (int i = whole(1, 20); i > 0; --i) chart.x.categories.push_back(text());
    } else {
      choose(chart.x);
    }
    for (int i = whole(0, 7); i > 0; --i) {
      Series series{"", static_cast<Mark>(whole(0, 2)), {}, whole(0, 4) == 0};
      for (int k = whole(0, 12); k > 0; --k) series.samples.push_back(sample(chart, series.mark));
      std::ranges::stable_sort(series.samples, {}, &Sample::position);
      chart.series.push_back(std::move(series));
    }
    for (int i = whole(0, 3); i > 0; --i) {
      const bool vertical = maybe();
      chart.lines.push_back({vertical ? Direction::vertical : Direction::horizontal,
                             number(vertical ? chart.x : chart.y), ""});
    }
  }

  Sample sample(const Chart& chart, Mark mark) {
    Sample sample{number(chart.x), {}};
    if (whole(0, 5) == 0) return sample;
    sample.value = number(chart.y);
    if (maybe()) {
      const double a = number(chart.y), b = number(chart.y);
      sample.spread = Range{std::min(a, b), std::max(a, b)};
    }
    if (mark == Mark::points && maybe()) sample.name = text();
    return sample;
  }

  void add_heat_map(Chart& chart) {
    HeatMap map{text(), {}};
    const int rows = whole(1, 15), columns = whole(1, 15);
    for (int i = 0; i < columns; ++i) chart.x.categories.push_back(text());
    for (int i = 0; i < rows; ++i) {
      chart.y.categories.push_back(text());
      auto& row = map.rows.emplace_back();
      for (int k = 0; k < columns; ++k)
        row.push_back(whole(0, 4) == 0 ? std::nullopt : std::optional(number({})));
    }
    chart.heat_map = map;
  }

  std::mt19937_64 random_;
};

void expect_inside(const std::vector<ReadPath>& paths, const Box& plot, int number) {
  const double reach = 4.6;  // of a corner of a mark whose middle is inside
  for (const ReadPath& path : paths) {
    if (path.node.attribute("clip-path")) continue;
    for (const auto& line : path.lines) {
      for (const auto [x, y] : line) {
        EXPECT_TRUE(x >= plot.left - reach && x <= plot.right + reach && y >= plot.top - reach &&
                    y <= plot.bottom + reach)
            << "chart " << number << ": " << x << ", " << y;
      }
    }
  }
}

/// What is clipped lies inside, but for a line along the edge.
void expect_clips_to(const ReadSvg& svg, const Box& plot) {
  const pugi::xml_node clip = svg.root().child("clipPath").child("rect");
  const double left = clip.attribute("x").as_double(), top = clip.attribute("y").as_double();
  EXPECT_GE(left, plot.left - 3);
  EXPECT_GE(top, plot.top - 3);
  EXPECT_LE(left + clip.attribute("width").as_double(), plot.right + 3);
  EXPECT_LE(top + clip.attribute("height").as_double(), plot.bottom + 3);
}

TEST(RandomCharts, AreWellFormedWithAllMarksInsideThePlot) {
  RandomCharts random(28);
  std::size_t marks = 0;
  for (int i = 0; i < charts && !testing::Test::HasFailure(); ++i) {
    const Chart chart = random.next();
    const Box plot = frame_of(chart).plot;
    const ReadSvg svg(to_svg(chart));
    std::vector<ReadPath> found =
        chart.heat_map ? svg.paths("shape-rendering", "crispEdges") : svg.paths("fill", "none");
    if (!chart.heat_map) expect_clips_to(svg, plot);
    // Without labels there is no legend: all but the axes and the grid are marks.
    std::erase_if(found, [](const ReadPath& path) {
      const std::string stroke = path.node.attribute("stroke").value();
      return stroke == "#e4e4e4" || stroke == "#888888";
    });
    expect_inside(found, plot, i);
    marks += found.size();
  }
  EXPECT_GT(marks, static_cast<std::size_t>(charts));
}

TEST(RandomCharts, HaveAllPathsAndTextsInThePicture) {
  RandomCharts random(29);
  for (int i = 0; i < charts && !testing::Test::HasFailure(); ++i) {
    Chart chart = random.next();
    for (Series& series : chart.series)
      series.label = fmt::format("series {}", 1 + &series - chart.series.data());
    for (ReferenceLine& line : chart.lines) line.label = "a line that is there to be looked at";
    const ReadSvg svg(to_svg(chart));
    const double width = svg.root().attribute("width").as_double();
    const double height = svg.root().attribute("height").as_double();
    EXPECT_GE(width, chart.width);
    EXPECT_GE(height, chart.height);
    expect_inside(svg.paths("fill", "none"), {0, width, 0, height}, i);
    EXPECT_EQ(svg.cut_texts(), "") << "chart " << i;
  }
}

}  // namespace
}  // namespace ricochet::report
