#include "src/report/gnuplot.h"

#include <gmock/gmock.h>

#include <boost/property_tree/xml_parser.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "src/report/process.h"
#include "src/report/svg.h"
#include "tests/report/sample_charts.h"

namespace ricochet::report {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;
constexpr std::chrono::minutes plenty(1);
using Tree = boost::property_tree::ptree;

Tree parse(const std::string& svg) {
  std::istringstream stream(svg);
  Tree tree;
  boost::property_tree::read_xml(stream, tree);
  return tree;
}

/// All text between the tags, as a reader sees it.
std::string visible_text(const Tree& tree) {
  std::string text;
  for (const auto& [name, child] : tree) {
    if (name == "text") text += child.data() + "\n";
    text += visible_text(child);
  }
  return text;
}

std::vector<std::string> ids(const std::string& svg) {
  static const std::regex pattern("[ <]id=\"([^\"]*)\"");
  std::vector<std::string> found;
  for (std::sregex_iterator it(svg.begin(), svg.end(), pattern), end; it != end; ++it)
    found.push_back((*it)[1]);
  return found;
}

/// How many lines or areas the paths with an attribute have.
int moves_of(const std::string& svg, const std::string& attribute) {
  int moves = 0;
  for (auto at = svg.find(attribute); at != std::string::npos; at = svg.find(attribute, at + 1)) {
    const auto from = svg.find(" d=\"", at) + 4;
    const std::string data = svg.substr(from, svg.find('"', from) - from);
    moves +=
        static_cast<int>(std::ranges::count_if(data, [](char c) { return c == 'M' || c == 'm'; }));
  }
  return moves;
}

/// One of every kind.
std::vector<Chart> gallery() {
  Chart steps = line_chart({{1, 1, Range{0.5, 2}}, {10, 5, Range{4, 6}}, {100, {}}, {1000, 7}});
  steps.name = "steps";
  steps.series[0].mark = Mark::steps;
  steps.x.scale = Scale::logarithmic;
  steps.lines = {{Direction::vertical, 9, "paper"}, {Direction::horizontal, 3, "wall"}};
  Chart names = line_chart({{0, 3}, {1, {}}});
  names.name = "names";
  names.series[0].mark = Mark::points;
  names.x.categories = {"first", "second"};
  Chart many = line_chart({{0, 1}, {1, 2}});
  many.name = "many";
  for (int i = 0; i < 11; ++i)
    many.series.push_back({"solver " + std::to_string(i), Mark::points, {{0.5, 1.0 + i}}});
  return {line_chart({{0, 1}, {1, 2}}), steps, names, many, heat_map_chart({{1.5, 2}, {{}, 4}})};
}

TEST(Gnuplot, WritesWellFormedXmlForEveryKindOfChart) {
  for (const std::string& svg : to_svgs(gallery())) {
    EXPECT_NO_THROW(parse(svg)) << svg;
    EXPECT_THAT(svg, AllOf(HasSubstr("role=\"img\""), Not(HasSubstr("<script")),
                           Not(HasSubstr("font-family=\"Body")), Not(HasSubstr("href=\"file"))));
  }
}

TEST(Gnuplot, NamesPointsWhereThereIsRoomAndPaleOnesOnlyNearby) {
  Chart chart = line_chart({});
  chart.name = "named";
  chart.series[0].mark = Mark::points;
  chart.series[0].samples = {{0, 1, Range{0.5, 2}, "first"}, {4, 3, {}, "second"}};
  Series crowd{"", Mark::points, {}, true};
  for (int k = 0; k < 40; ++k) crowd.samples.push_back({2, 2, {}, "crowd"});
  chart.series.push_back(crowd);
  const std::string text = visible_text(parse(to_svgs({chart})[0]));
  EXPECT_THAT(text, AllOf(HasSubstr("first"), HasSubstr("second"), HasSubstr("crowd")));
  std::size_t written = 0;
  for (auto at = text.find("crowd"); at != std::string::npos; at = text.find("crowd", at + 1)) {
    ++written;
  }
  EXPECT_LT(written, 9);
}

TEST(Gnuplot, WritesTheSameBytesEveryTime) {
  const std::vector<Chart> charts = gallery();
  const std::vector<std::string> svgs = to_svgs(charts);
  for (std::size_t i = 0; i < charts.size(); ++i) EXPECT_EQ(to_svg(charts[i]), svgs[i]);
}

TEST(Gnuplot, GivesEveryIdOfEveryChartAName) {
  std::set<std::string> all;
  for (const std::string& svg : to_svgs(gallery())) {
    const std::vector<std::string> found = ids(svg);
    EXPECT_GE(found.size(), 2U);
    for (const std::string& id : found) EXPECT_TRUE(all.insert(id).second) << id;
  }
}

TEST(Svg, IsStackedOnAnother) {
  const std::vector<Chart> charts = gallery();
  const std::vector<std::string> svgs = to_svgs(charts);
  EXPECT_EQ(stacked({svgs[0]}), svgs[0]);
  const std::string both = stacked({svgs[0], svgs[1]});
  const Tree root = parse(both).get_child("svg");
  EXPECT_EQ(root.get<int>("<xmlattr>.width"), std::max(charts[0].width, charts[1].width));
  EXPECT_EQ(root.get<int>("<xmlattr>.height"), charts[0].height + charts[1].height);
  std::vector<int> places;
  for (const auto& [name, child] : root) {
    if (name == "svg") places.push_back(child.get<int>("<xmlattr>.y"));
  }
  EXPECT_THAT(places, testing::ElementsAre(0, charts[0].height));
  EXPECT_EQ(visible_text(root), visible_text(parse(svgs[0])) + visible_text(parse(svgs[1])));
}

TEST(Gnuplot, PointsOnlyToIdsThatExist) {
  static const std::regex pattern("(?:href=\"#|url\\(#)([^\")]*)");
  int references = 0;
  for (const std::string& svg : to_svgs(gallery())) {
    const std::vector<std::string> found = ids(svg);
    for (std::sregex_iterator it(svg.begin(), svg.end(), pattern), end; it != end; ++it) {
      EXPECT_THAT(found, testing::Contains((*it)[1].str()));
      ++references;
    }
  }
  EXPECT_EQ(references, 3);  // the bar of colours and hatched cells of the heat map, and its legend
}

TEST(Gnuplot, DrawsLinesAcrossPlotsWhoseLimitsHaveManyDigits) {
  // Rounded to fewer digits, both ends of a line are outside, and gnuplot drops it.
  Chart chart = line_chart({{1, 1}, {2, 2}});
  chart.x.range = chart.y.range = Range{1.0 / 3, 20.0 / 3};
  chart.lines = {{Direction::horizontal, 1, "one"}, {Direction::vertical, 2, "two"}};
  const std::string svg = to_svg(chart);
  for (const char* colour : {"#222222", "#f2b84b"}) {
    EXPECT_EQ(moves_of(svg, std::string("stroke=\"") + colour), 2) << colour;  // and in the legend
  }
}

TEST(Gnuplot, LabelsTicksByPlainNumbersWithATrueMinus) {
  Chart chart = line_chart({{-0.3, -2e6}, {0.3, 2e6}});
  EXPECT_THAT(visible_text(parse(to_svg(chart))),
              AllOf(HasSubstr("−0.2\n"), HasSubstr("\n0\n"), HasSubstr("\n0.2\n"),
                    HasSubstr("−2000000\n"), HasSubstr("\n2000000\n"), Not(HasSubstr("-"))));
}

TEST(Gnuplot, KeepsSpecialCharactersInEveryLabel) {
  const std::string odd = R"(<b> & "q" 'p' a_b^{c} @d \n 50 % `date` $x #1 ω²)";
  Chart chart = line_chart({{0, 1}, {1, 2}});
  chart.title = odd + " title";
  chart.x.label = odd + " x";
  chart.series[0].mark = Mark::points;
  chart.x.categories = {"50 % <&> 'row' 0", "{a_b} `date` row 1"};
  chart.series[0].label = odd + " series";
  chart.lines = {{Direction::vertical, 1, odd + " line"}};
  chart.width = 1200;
  const std::string svg = to_svg(chart);
  const std::string text = visible_text(parse(svg));
  for (const std::string& row : chart.x.categories) EXPECT_THAT(text, HasSubstr(row + "\n"));
  for (const char* place : {" title", " x", " series", " line"})
    EXPECT_THAT(text, HasSubstr(odd + place + "\n"));
  EXPECT_EQ(parse(svg).get<std::string>("svg.title"), odd + " title");
}

TEST(Gnuplot, ShortensLongNamesOnAnAxisBetweenCharacters) {
  for (const std::string start : {"", "a"}) {
    std::string name = start;
    for (int i = 0; i < 40; ++i) name += "ω";
    Chart chart = heat_map_chart({{1}});
    chart.y.categories = {name};
    EXPECT_THAT(visible_text(parse(to_svg(chart))), HasSubstr("ωω…\n"));
  }
}

TEST(Gnuplot, IsNotFooledByLabelsThatLookLikeSvg) {
  Chart chart = line_chart({{0, 1}, {1, 2}});
  chart.title = "</svg><g id='gpDot'> url(#x) font-family=\"Body\"";
  EXPECT_THAT(visible_text(parse(to_svg(chart))), HasSubstr(chart.title));
}

TEST(Gnuplot, LeavesAGapWhereAValueIsMissing) {
  const auto strokes = [](const Chart& chart) {
    return moves_of(to_svg(chart), "stroke=\"#0072b2\"");
  };
  EXPECT_EQ(strokes(line_chart({{0, 1}, {1, 2}, {2, 3}, {3, 1}, {4, 2}})), 1);
  EXPECT_EQ(strokes(line_chart({{0, 1}, {1, 2}, {2, {}}, {3, 1}, {4, 2}})), 2);
}

TEST(Gnuplot, HatchesCellsWithoutAValueAndSaysSo) {
  const auto hatched = [](const std::string& svg) {
    return moves_of(svg, "fill=\"url(#map-gpPat");
  };
  const std::string svg = to_svg(heat_map_chart({{1, {}, 3}, {{}, 5, 6}}));
  EXPECT_EQ(hatched(svg), 2 + 1);  // and one in the legend
  EXPECT_THAT(svg, HasSubstr("no value"));
  const std::string complete = to_svg(heat_map_chart({{1, 2}}));
  EXPECT_EQ(hatched(complete), 0);
  EXPECT_THAT(complete, Not(HasSubstr("no value")));
}

TEST(Gnuplot, SaysWhereThereIsNoDataAtAll) {
  EXPECT_THAT(to_svg(line_chart({{0, {}}})), HasSubstr("no data"));
  EXPECT_THAT(to_svg(heat_map_chart({{{}, {}}})), HasSubstr("no data"));
}

TEST(Gnuplot, KeepsAStepCurveOfManyEqualSamplesSmall) {
  Chart chart = line_chart({});
  chart.series[0].mark = Mark::steps;
  for (int i = 0; i < 1800; ++i) chart.series[0].samples.push_back({0.01 * i, i / 600});
  EXPECT_LT(to_svg(chart).size(), 12000U);
}

/// Sets PATH for the length of a test.
class PathIs {
 public:
  explicit PathIs(const std::string& path) : before_(std::getenv("PATH")) {
    setenv("PATH", path.c_str(), 1);
  }
  ~PathIs() { setenv("PATH", before_.c_str(), 1); }
  PathIs(const PathIs&) = delete;
  PathIs& operator=(const PathIs&) = delete;

 private:
  std::string before_;
};

TEST(Gnuplot, NamesThePackageIfItIsMissing) {
  const PathIs nowhere("/nonexistent");
  EXPECT_THAT(
      [] {
        to_svg(line_chart({{0, 1}}));
      },
      ThrowsMessage<std::runtime_error>(
          AllOf(HasSubstr("gnuplot-nox"), HasSubstr("No such file"))));
}

TEST(Gnuplot, PassesOnWhatAFailingOneSaid) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "failing_gnuplot";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "gnuplot") << "#!/bin/sh\necho out of ink >&2\nexit 3\n";
  std::filesystem::permissions(folder / "gnuplot", std::filesystem::perms::owner_all);
  const PathIs here(folder.string());
  EXPECT_THAT(
      [] {
        to_svg(line_chart({{0, 1}}));
      },
      ThrowsMessage<std::runtime_error>(AllOf(HasSubstr("exit code 3"), HasSubstr("out of ink"))));
}

TEST(Svg, IsRefusedIfItIsCutOff) {
  EXPECT_THAT([] { finish_svg("<svg><title>Gnuplot</title><g>", "chart", "", ""); },
              ThrowsMessage<std::runtime_error>(HasSubstr("chart chart: no SVG")));
}

TEST(Process, CarriesMoreThanAPipeHolds) {
  const std::string text(1 << 20, 'x');
  EXPECT_EQ(run_process({"cat"}, text, plenty).output, text);
}

TEST(Process, SurvivesAProgramThatDoesNotRead) {
  EXPECT_EQ(run_process({"true"}, std::string(1 << 20, 'x'), plenty).status, 0);
}

TEST(Process, IsEndedAtItsLimit) {
  EXPECT_EQ(run_process({"sleep", "1000"}, "", std::chrono::milliseconds(50)).status, 124);
}

TEST(Process, SaysWhichSignalEndedIt) {
  EXPECT_EQ(run_process({"sh", "-c", "kill -SEGV $$"}, "", plenty).status, 128 + 11);
}

TEST(Process, SeesNothingOfTheEnvironmentButPathAndLocale) {
  setenv("GNUPLOT_LIB", "/nonexistent", 1);
  const std::string seen = run_process({"env"}, "", plenty).output;
  unsetenv("GNUPLOT_LIB");
  EXPECT_THAT(seen, AllOf(HasSubstr("LC_ALL=C.UTF-8\n"), HasSubstr("PATH="),
                          Not(HasSubstr("GNUPLOT_LIB"))));
}

TEST(Process, LeavesNoFileOpen) {
  const auto open_files = [] {
    return std::ranges::distance(std::filesystem::directory_iterator("/proc/self/fd"));
  };
  const auto before = open_files();
  run_process({"cat"}, "text", plenty);
  run_process({"no such program"}, "text", plenty);
  EXPECT_EQ(open_files(), before);
}

}  // namespace
}  // namespace ricochet::report
