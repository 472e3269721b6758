#include <gmock/gmock.h>

#include <limits>
#include <stdexcept>

#include "src/report/drawing.h"
#include "src/report/svg.h"
#include "tests/report/read_svg.h"
#include "tests/report/sample_charts.h"

namespace ricochet::report {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

Chart wrong_chart() {
  Chart chart = line_chart({{0, std::numeric_limits<double>::quiet_NaN()}});
  chart.name = "wrong";
  chart.title = "Wrong <one>";
  return chart;
}

TEST(DrawnChart, IsThePicture) {
  const Chart chart = line_chart({{0, 1}, {1, 2}});
  const DrawnChart drawn = draw(chart);
  EXPECT_TRUE(drawn.is_drawn());
  EXPECT_THAT(html_of(chart, drawn), testing::StartsWith(to_svg(chart)));
  EXPECT_EQ(markdown_of(drawn), "![A title](chart.svg)");
}

TEST(DrawnChart, IsElseTheReasonInWords) {
  const DrawnChart drawn = draw(wrong_chart());
  EXPECT_FALSE(drawn.is_drawn());
  EXPECT_EQ(failure_of(drawn),
            "chart wrong could not be drawn: series \"path\", sample 0: nan is not finite");
  EXPECT_THAT(html_of(wrong_chart(), drawn),
              AllOf(HasSubstr("Wrong &lt;one&gt;"), HasSubstr("nan is not finite")));
  EXPECT_THAT(markdown_of(drawn), AllOf(HasSubstr("Wrong &lt;one>"), HasSubstr("not finite")));
}

TEST(Plot, HasAllChartsThatCanBeDrawn) {
  const Chart chart = line_chart({{0, 1}, {1, 2}});
  const Plot plot = plot_of({wrong_chart(), chart});
  EXPECT_EQ(plot.svg, to_svg(chart));
  EXPECT_THAT(plot.failures, ElementsAre(HasSubstr("chart wrong")));
  EXPECT_THAT(plot_of({wrong_chart()}).svg, IsEmpty());
}

TEST(Failures, EndACommandIfThereAreAny) {
  EXPECT_NO_THROW(require_none({}));
  EXPECT_THAT(
      [] {
        require_none({"chart a", "chart b"});
      },
      ThrowsMessage<std::runtime_error>("chart a; chart b"));
}

}  // namespace
}  // namespace ricochet::report
