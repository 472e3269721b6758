#include "src/report/headline_template.h"

#include "src/report/chart_template.h"
#include "src/report/table_template.h"

namespace ricochet::report {
namespace {

Excerpt excerpt_of(const Part& part, const Scopes& scopes) {
  Excerpt excerpt{part.text("topic"),
                  part.filled_text("heading", scopes),
                  part.filled_text("text", scopes),
                  {},
                  {}};
  for (const Part& link : part.parts("links")) {
    for (const Scopes& place : places_of(link, scopes)) {
      excerpt.links.push_back({filled(link.text("text"), place), link.filled_text("to", place)});
    }
  }
  if (part.has("table")) excerpt.table = table_of(part.part("table"), scopes);
  return excerpt;
}

/// Omits the samples at or beyond the end of the range of y, where failed runs are drawn.
Chart inner_chart_of(const Part& part, const Scopes& scopes) {
  Chart chart = chart_of(part, scopes);
  for (Series& series : chart.series) {
    std::erase_if(series.samples, [&](const Sample& sample) {
      return !sample.value || (chart.y.range && *sample.value >= chart.y.range->upper);
    });
  }
  std::erase_if(chart.series, [](const Series& series) { return series.samples.empty(); });
  return chart;
}

}  // namespace

Headline headline_of(const Part& page, const Scopes& scopes) {
  Headline headline;
  headline.title = filled(page.text("title"), scopes);
  if (!page.has("headline")) return headline;
  const Part part = page.part("headline");
  headline.version = headline_version;
  headline.finding = part.filled_text("finding", scopes);
  headline.command = part.filled_text("made_by", scopes);
  headline.group = part.filled_text("group", scopes);
  headline.label = part.filled_text("label", scopes);
  for (const Part& excerpt : part.parts("excerpt")) {
    for (const Scopes& place : places_of(excerpt, scopes)) {
      headline.excerpts.push_back(excerpt_of(excerpt, place));
    }
  }
  for (const Part& chart : part.parts("chart")) {
    for (const Scopes& place : places_of(chart, scopes)) {
      headline.charts.push_back(inner_chart_of(chart, place));
    }
  }
  if (part.has("holds")) headline.holds = part.texts("holds");
  return headline;
}

}  // namespace ricochet::report
