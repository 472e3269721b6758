#pragma once

#include <string>
#include <vector>

#include "src/report/chart.h"
#include "src/report/json.h"
#include "src/report/table.h"

namespace ricochet::report {

/// Version of this struct. Data of another version are not read.
inline constexpr int headline_version = 1;

/// A place in a report, from one of its pages: "" is that page, "#thresholds" a section of it,
/// "count" a page in a folder below, "../count" one beside it.
struct Link {
  std::string text;
  std::string to;
};

/// A part of a report that the front page repeats.
struct Excerpt {
  std::string topic;  ///< the front page's heading for it
  std::string heading;
  std::string text;
  std::vector<Link> links;
  Table table;  ///< empty if it has no columns
};

/// A report's summary for a front page. It is stored in data.json, except for the parts repeated
/// from the page, which are drawn from the data when needed.
struct Headline {
  int version = 0;
  std::string title;
  std::string finding;             ///< the result, in a sentence
  std::string command;             ///< that made it; empty: that of its kind, with the time
  std::vector<std::string> holds;  ///< data for interactive parts of a front page, see src/site
  std::string group, label;  ///< in the navigation, of a further page that stands in it by itself
  std::vector<Excerpt> excerpts;
  std::vector<Chart> charts;  ///< named like the sections that they link to
};
RICOCHET_JSON(Headline, version, title, finding, command, holds);

NLOHMANN_JSON_SERIALIZE_ENUM(Scale,
                             {{Scale::linear, "linear"}, {Scale::logarithmic, "logarithmic"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Mark, {{Mark::line, "line"},
                                    {Mark::steps, "steps"},
                                    {Mark::points, "points"}})
RICOCHET_WRITTEN_AS_JSON(Range, lower, upper);
RICOCHET_WRITTEN_AS_JSON(Axis, label, scale, range);
RICOCHET_WRITTEN_AS_JSON(Sample, position, value, name);
RICOCHET_WRITTEN_AS_JSON(Series, label, mark, pale, samples);
RICOCHET_WRITTEN_AS_JSON(Chart, name, title, x, y, series);

}  // namespace ricochet::report
